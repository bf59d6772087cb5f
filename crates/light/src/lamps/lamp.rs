//! One emitter: an element, or a surface, that emits, as rays are sent to it.

use std::f64::consts::PI;

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_elements::sampling::area_preserving_map::AreaPreservingMap;
use radiosity_geom::{Aabb, DVec3, Plane};

use crate::receiver_point::ReceiverPoint;

/// An element that emits.
#[derive(Debug)]
pub(crate) struct Lamp {
    /// Index of the element.
    pub element: usize,
    /// Mean over the bands of the exitance over the band's scale.
    pub brightness: f64,
    /// Area (scene length²).
    pub area: f64,
    /// Map to points on it, spread over its area.
    pub area_map: AreaPreservingMap,
    /// Middle of its box, and the radius of a ball around that which holds it (scene length).
    pub(super) center: DVec3,
    pub(super) radius: f64,
    /// Its plane, if it is flat.
    pub(super) plane: Option<Plane>,
}

impl Lamp {
    /// An open element of this brightness; None where it is dark or covered.
    pub(crate) fn of(elements: &[Element], element: usize, brightness: f64) -> Option<Self> {
        let own = &elements[element];
        let bounds = Aabb::around(own.hull.iter().copied());
        (own.contact.is_none() && brightness > 0.0).then(|| Self {
            element,
            center: bounds.center(),
            radius: 0.5 * bounds.diagonal(),
            area: own.area,
            plane: own.plane,
            brightness,
            area_map: AreaPreservingMap::over(own),
        })
    }

    /// The whole of a surface of which this is an element, with all that emits there, in `plane` if it is
    /// flat.
    pub(crate) fn whole(self, elements: &[&Element], plane: Option<Plane>) -> Self {
        let bounds = Aabb::around(elements.iter().flat_map(|element| element.hull.iter().copied()));
        let patches: Vec<Patch> =
            elements.iter().flat_map(|element| element.patches.iter().cloned()).collect();
        Self {
            center: bounds.center(),
            radius: 0.5 * bounds.diagonal(),
            area: elements.iter().map(|element| element.area).sum(),
            plane,
            area_map: AreaPreservingMap::of(&patches),
            ..self
        }
    }

    /// Distance of a point from its middle (scene length).
    pub(crate) fn distance(&self, point: DVec3) -> f64 {
        self.center.distance(point)
    }

    /// Its plane, if it is flat.
    pub(crate) fn plane(&self) -> Option<Plane> {
        self.plane
    }

    /// Radius of a ball around its middle that contains it (scene length).
    pub(crate) fn radius(&self) -> f64 {
        self.radius
    }

    /// About the light that it sends to a point without shadows; 0 only where it sends none.
    pub(crate) fn bound(&self, receiver: &ReceiverPoint) -> f64 {
        let height = self.plane.map(|plane| plane.height(receiver.position));
        let step = self.center - receiver.position;
        let is_above = |normal: DVec3| step.dot(normal) + self.radius > 0.0;
        let may_send = height.is_none_or(|height| height > 0.0)
            && is_above(receiver.normal)
            && receiver.ground.is_none_or(is_above);
        if !may_send {
            return 0.0;
        }
        let distance = step.length();
        let cosine = cosine(receiver, step, self.radius);
        let own = height.map_or(1.0, |height| (height / distance.max(height)).max(f64::EPSILON));
        self.brightness * (self.area * cosine * own / (PI * distance * distance)).min(1.0)
    }
}

/// Bound of the cosine at a receiver of what lies in a ball of this radius, whose middle is this `step` away.
#[inline]
pub(super) fn cosine(receiver: &ReceiverPoint, step: DVec3, radius: f64) -> f64 {
    let distance = step.length();
    let above = |normal: DVec3| (step.dot(normal) + radius) / (distance + radius);
    above(receiver.normal).min(receiver.ground.map_or(1.0, above))
}
