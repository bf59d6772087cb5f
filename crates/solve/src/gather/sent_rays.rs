//! Rays from receivers to what they meet first, and to points on emitters: what every way of finding light by
//! rays is made of.
//!
//! Light of emitters that rays of both kinds find is divided among them by the balance heuristic (E. Veach, L. Guibas,
//! SIGGRAPH 1995, 419-428): with the density κ (1 / scene length²) of n cosine-distributed rays and q of m to emitters,
//!
//! ```text
//! κ/(n κ + m q)   by each cosine-distributed one, over κ ,      κ/(n κ + m q)   by each to an emitter .
//! ```

use std::f64::consts::PI;

use radiosity_elements::Elements;
use radiosity_elements::measure::WeightedNode;
use radiosity_elements::sampling::lambert::lambert;
use radiosity_geom::{COINCIDENT, DVec3, Encounter};
use radiosity_light::emitters::{Emitters, Radiances};
use radiosity_light::lamps::{Lamps, Shares, Target};
use radiosity_light::point_lights::PointLights;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;

use crate::gather::walks::front_met;
use crate::solution::SurfacePlace;

/// Difference of the distances of a target and of what a ray to it met, over them, up to which they are one place:
/// rounding of single precision.
const SAME_PLACE: f64 = 1e-6;

/// Distance of an emitter, in its radii, within which its light has peaks: rays to it go beside others. Measured in a
/// shop with tubes: with 2 and 1 the readings took more rays, and erred more.
pub(super) const NEAR: f64 = 4.0;

/// A scene with the light that its surfaces emit, as rays ask for it.
#[derive(Debug)]
pub(super) struct SentRays<'a> {
    pub(super) elements: &'a Elements,
    pub(super) visibility: &'a Visibility,
    pub(super) lamps: Lamps,
    pub(super) points: &'a PointLights,
    radiances: &'a Radiances,
    /// Distance of surfaces that cover each other (scene length).
    touching: f64,
}

/// Where a ray meets the front of a surface.
pub(super) struct Met {
    pub(super) element: usize,
    pub(super) place: SurfacePlace,
    /// Unit normal of the front.
    pub(super) normal: DVec3,
    /// Distance from where it began.
    pub(super) distance: f64,
    /// Direction of the ray.
    direction: DVec3,
}

/// Light of an emitter along a ray that reaches it.
pub(super) struct Shining {
    pub(super) element: usize,
    /// Kernel κ(x, y) between both ends (1 / scene length²).
    pub(super) kernel: f64,
    /// Radiance over that of a diffuse emitter, times the weight of the point.
    pub(super) relative: f64,
    /// Density of such points on the emitter (1 / scene length²).
    pub(super) density: f64,
}

/// Light of an emitter that a ray to it stands for.
pub(super) struct LampLight {
    pub(super) element: usize,
    /// Irradiance over the exitance of the element.
    pub(super) share: f64,
}

/// Rays of either kind that the balance heuristic combines, per cosine-distributed ray.
#[derive(Clone, Copy)]
pub(super) struct RayMix {
    pub(super) cosine: f64,
    pub(super) to_lamps: f64,
}

/// Rays to emitters, or to what glows, beside cosine-distributed ones.
#[derive(Clone, Copy)]
pub(super) struct AimedRays<'a> {
    /// Shares of their targets in them.
    pub(super) shares: &'a Shares<'a>,
    /// Number of them for each cosine-distributed ray.
    pub(super) ratio: f64,
}

impl AimedRays<'_> {
    /// Part of the light of what a cosine-distributed ray met, or of the same place as a target, that the balance
    /// heuristic leaves to each ray, for all of which the former are counted.
    pub(super) fn left(&self, receiver: &ReceiverPoint, met: &Met) -> f64 {
        match self.ratio * self.shares.density(met.element) {
            0.0 => 1.0,
            density => {
                let kernel = met.kernel(receiver);
                kernel / (kernel + density)
            }
        }
    }
}

impl Met {
    /// Kernel κ(x, y) from the receiver, where the ray began, to where it ended (1 / scene length²).
    pub(super) fn kernel(&self, receiver: &ReceiverPoint) -> f64 {
        let cosines = receiver.normal.dot(self.direction) * -self.normal.dot(self.direction);
        cosines / (PI * self.distance * self.distance)
    }

    /// The front as a receiver.
    pub(super) fn there(&self) -> ReceiverPoint {
        ReceiverPoint::on(self.place.surface, self.place.position, self.normal)
    }

    /// The other side as a receiver, which lies at this place.
    pub(super) fn beyond(&self, place: &SurfacePlace) -> ReceiverPoint {
        ReceiverPoint::on(place.surface, self.place.position, -self.normal)
    }
}

impl<'a> SentRays<'a> {
    /// Rays among `elements`, to the emitters among them, whose brightness counts relative to `scale` per band (W m⁻²).
    pub(super) fn among(
        elements: &'a Elements,
        sources: &Emitters<'a>,
        visibility: &'a Visibility,
        scale: &[f64],
    ) -> Self {
        let lamps = Lamps::new(elements.list(), &sources.coatings, scale);
        let touching = COINCIDENT * visibility.bounds().diagonal();
        let Emitters { radiances, points, .. } = *sources;
        Self { elements, visibility, lamps, points, radiances, touching }
    }

    /// The front that a ray meets first; None where that is covered by another surface, and the ray does not
    /// come from it: what is covered shines only on what covers it.
    pub(super) fn met(&self, receiver: &ReceiverPoint, direction: DVec3) -> Option<Met> {
        let Encounter { surface, hit, normal, .. } = front_met(self.visibility, receiver, direction)?;
        let element = self.elements.at(surface, [hit.u, hit.v])?;
        let own = &self.elements.list()[element];
        let is_hidden = own.contact.is_some() && hit.t > self.touching;
        let position = receiver.position + hit.t * direction;
        let place = SurfacePlace { surface, parameters: [hit.u, hit.v], position };
        let curved = || normal.unwrap_or_else(|| self.elements.shape(surface).jet(hit.u, hit.v).normal);
        let normal = own.plane.map_or_else(curved, |plane| plane.normal);
        (!is_hidden).then_some(Met { element, place, normal, distance: hit.t, direction })
    }

    /// Radiance over that of a diffuse emitter of what a ray met, against the ray.
    pub(super) fn relative(&self, met: &Met) -> f64 {
        self.radiances.relative(met.place.surface, -met.direction)
    }

    /// The light of a point of an emitter at a receiver, by a ray; None where nothing arrives.
    pub(super) fn shining(&self, receiver: &ReceiverPoint, target: &Target) -> Option<Shining> {
        let WeightedNode { node, weight } = target.place;
        let kernel = receiver.kernel_to(&node)?;
        if !self.visibility.is_free(receiver.surface, receiver.position, node.position) {
            return None;
        }
        let surface = self.elements.list()[target.element].surface;
        let into = (receiver.position - node.position).normalize_or_zero();
        let relative = weight * self.radiances.relative(surface, into);
        Some(Shining { element: target.element, kernel, relative, density: target.density })
    }

    /// Part of the exitance of what a cosine-distributed ray meets that the balance heuristic leaves it beside the
    /// rays `to_lamps`, times its relative radiance; none where there are none.
    pub(super) fn exitance_left(
        &self,
        receiver: &ReceiverPoint,
        met: &Met,
        to_lamps: Option<AimedRays<'_>>,
    ) -> f64 {
        to_lamps.map_or(0.0, |rays| rays.left(receiver, met) * self.relative(met))
    }

    /// The target of a ray as what the ray meets; None where something hides it.
    pub(super) fn met_at(&self, receiver: &ReceiverPoint, target: &Target) -> Option<Met> {
        let step = target.place.node.position - receiver.position;
        let distance = step.length();
        if step.dot(receiver.normal) <= 0.0 {
            return None;
        }
        let met = self.met(receiver, step / distance)?;
        let is_there = (met.distance - distance).abs() <= SAME_PLACE * distance;
        (met.element == target.element && is_there).then_some(met)
    }

    /// The light that a ray to an emitter stands for beside others; None where nothing arrives.
    pub(super) fn lamp_light(
        &self,
        receiver: &ReceiverPoint,
        target: &Target,
        mix: RayMix,
    ) -> Option<LampLight> {
        let lamp = self.shining(receiver, target)?;
        let both = mix.cosine * lamp.kernel + mix.to_lamps * lamp.density;
        Some(LampLight { element: lamp.element, share: lamp.relative * lamp.kernel / both })
    }

    /// The light of emitters at a point by one ray to them, which the numbers choose, and near an emitter, where
    /// light by such rays has peaks, by a cosine-distributed one beside it.
    pub(super) fn direct(
        &self,
        receiver: &ReceiverPoint,
        shares: &Shares<'_>,
        [choice, s, t, polar, turn]: [f64; 5],
        is_near: bool,
    ) -> impl Iterator<Item = LampLight> {
        let mix = RayMix { cosine: if is_near { 1.0 } else { 0.0 }, to_lamps: 1.0 };
        let to_lamp = self.lamp_light(receiver, &shares.target([choice, s, t]), mix);
        let along = is_near.then(|| lambert(receiver.normal, [polar, turn]));
        let beside = along.and_then(|direction| self.met(receiver, direction)).map(|met| {
            let to_lamps = Some(AimedRays { shares, ratio: 1.0 });
            LampLight { element: met.element, share: self.exitance_left(receiver, &met, to_lamps) }
        });
        to_lamp.into_iter().chain(beside)
    }
}
