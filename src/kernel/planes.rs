//! How the planes of two elements lie to each other.

use radiosity_geom::DVec3;

use crate::elements::Element;

/// Heights below this part of the pair's size are none.
const FLAT: f64 = 1e-9;

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

/// The planes of two elements that together are of `size` (scene length).
pub(super) fn of(receiver: &Element, emitter: &Element, size: f64) -> Planes {
    let range = |plane: &(DVec3, DVec3), other: &Element| {
        let heights = other.hull.iter().map(|point| (point - plane.0).dot(plane.1));
        heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)))
    };
    let tolerance = FLAT * size;
    for (plane, other) in [(&receiver.plane, emitter), (&emitter.plane, receiver)] {
        let Some(plane) = plane else { continue };
        let (low, high) = range(plane, other);
        if high <= tolerance {
            return if low >= -tolerance { Planes::Coplanar } else { Planes::Facing };
        }
    }
    Planes::Exchanging
}
