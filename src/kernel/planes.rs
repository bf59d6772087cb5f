//! How the planes of two elements lie to each other.

use radiosity_geom::DVec3;

use crate::elements::Element;

/// Heights below this part of the extent of what stands over a plane are none.
const FLAT: f64 = 1e-9;
/// Rounding of a height over a plane, as a part of the distance from the plane's point: some tens of units in the last place.
const ROUNDING: f64 = 1e-14;

/// What the planes of two elements tell of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Planes {
    /// Nothing.
    Exchanging,
    /// One lies behind the other.
    Facing,
    /// Both lie in one plane.
    Coplanar,
}

/// The planes of two elements. Elements of one planar surface lie in its plane, however it was rounded.
pub(super) fn of(receiver: &Element, emitter: &Element) -> Planes {
    if receiver.surface == emitter.surface && receiver.plane.is_some() {
        return Planes::Coplanar;
    }
    for (plane, other) in [(&receiver.plane, emitter), (&emitter.plane, receiver)] {
        let Some(plane) = plane else { continue };
        let [low, high] = heights(*plane, other);
        if high <= 0.0 {
            return if low >= 0.0 { Planes::Coplanar } else { Planes::Facing };
        }
    }
    Planes::Exchanging
}

/// The least and the largest height of an element over a plane (scene length); what counts as none is 0. The tolerance goes by
/// the extent of the element, not of the plane's: small things lie over large ones.
fn heights((point, normal): (DVec3, DVec3), element: &Element) -> [f64; 2] {
    let tolerance = FLAT * element.extent;
    let height = |x: &DVec3| {
        let offset = x - point;
        let height = offset.dot(normal);
        if height.abs() <= tolerance + ROUNDING * offset.length() { 0.0 } else { height }
    };
    let range = |[low, high]: [f64; 2], h: f64| [low.min(h), high.max(h)];
    element.hull.iter().map(height).fold([f64::INFINITY, f64::NEG_INFINITY], range)
}
