//! Relative position of the planes of two elements.

use radiosity_elements::Element;
use radiosity_geom::{DVec3, Plane, touching};

/// Exchange of light between two elements, as far as their planes tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Planes {
    /// The elements may exchange light.
    Exchanging,
    /// One element lies behind the plane of the other: they exchange none.
    Behind,
    /// Both elements lie in one plane: they exchange none.
    Coplanar,
}

/// Heights of a corner over a plane, over the extent of its element, beyond which all corners lie on one
/// side: 1 and what rounding may add.
const FAR: f64 = 1.001;

/// Elements of one planar surface count as coplanar, however their planes were rounded.
pub fn of(receiver: &Element, emitter: &Element) -> Planes {
    if receiver.surface == emitter.surface && receiver.level.is_some() {
        return Planes::Coplanar;
    }
    let extent = receiver.extent.min(emitter.extent);
    for (plane, other) in [(&receiver.level, emitter), (&emitter.level, receiver)] {
        let Some(plane) = plane else { continue };
        let [low, high] = heights(plane, other, extent);
        if high <= 0.0 {
            return if low >= 0.0 { Planes::Coplanar } else { Planes::Behind };
        }
    }
    Planes::Exchanging
}

/// Least and largest height of an element over a plane (scene length), or bounds of the same sign. Heights
/// within rounding are 0, for elements of which the smaller is `extent` wide.
fn heights(plane: &Plane, element: &Element, extent: f64) -> [f64; 2] {
    let first = plane.height(element.hull[0]);
    if first.abs() > FAR * (element.extent + touching(extent, element.hull[0].distance(plane.point))) {
        return [first; 2];
    }
    let height = |x: &DVec3| {
        let height = plane.height(*x);
        if height.abs() <= touching(extent, x.distance(plane.point)) { 0.0 } else { height }
    };
    let range = |[low, high]: [f64; 2], h: f64| [low.min(h), high.max(h)];
    element.hull.iter().map(height).fold([f64::INFINITY, f64::NEG_INFINITY], range)
}
