//! Which element of a pair may be the outer one of a shadow by outlines where cans, cones and disks stand
//! between.
//!
//! The inner element is a polygon, and all frusta lie on its front: then all of it within the cone over their
//! outlines is hidden from before it. They may stand on it, but not touch it at a point or along a generator: there
//! outlines are tangent to its sides from wherever they are seen. The outer element lies outside of all frusta and
//! touches none: what a lid in its plane hides would jump along the rim.

use radiosity_elements::Element;
use radiosity_geom::{COINCIDENT, DVec3, separated};
use radiosity_visibility::Visibility;
use radiosity_visibility::frustum::Frustum;

/// Whether each element of a pair may be the outer one, so that the other is a polygon, past `blockers`.
pub(crate) fn outer_sides(pair: [&Element; 2], blockers: &[usize], visibility: &Visibility) -> [bool; 2] {
    let may_be_outer = |outer: usize| {
        let (own, other) = (pair[outer], pair[1 - outer]);
        let mut frusta =
            blockers.iter().filter_map(|own| Some((visibility.frustum(*own)?, visibility.hull(*own))));
        other.plane.is_some()
            && frusta.all(|(frustum, hull)| is_before(other, frustum) && is_outside(own, frustum, hull))
    };
    [0, 1].map(may_be_outer)
}

/// Whether cans, cones or disks are among `blockers`.
pub(crate) fn have_frusta(blockers: &[usize], visibility: &Visibility) -> bool {
    blockers.iter().any(|own| visibility.frustum(*own).is_some())
}

/// Whether all `blockers` are frusta or balls.
pub(crate) fn are_round(blockers: &[usize], visibility: &Visibility) -> bool {
    blockers.iter().all(|own| visibility.frustum(*own).is_some() || visibility.ball(*own).is_some())
}

/// Whether shadows of `bodies` can be summed: all are frusta or balls, and no line from an element meets two of them.
pub(crate) fn are_apart(outer: &Element, bodies: &[usize], visibility: &Visibility) -> bool {
    // The nearer one of two would lie between the element and the other.
    let comes_before = |near: usize, far: usize| {
        near != far && !separated(&outer.hull, visibility.hull(far), visibility.hull(near), 0.0)
    };
    are_round(bodies, visibility)
        && !bodies.iter().any(|near| bodies.iter().any(|far| comes_before(*near, *far)))
}

/// Whether all of a frustum lies on the front of a polygon, and touches it by a lid at the most.
fn is_before(element: &Element, frustum: &Frustum) -> bool {
    let stands = element.level.is_some_and(|level| frustum.stands_on(&level));
    is_above(element, frustum)
        || (stands && element.plane.is_some_and(|plane| frustum.heights(&plane)[1] > 0.0))
}

/// Whether all of a frustum lies above the plane of a polygon.
fn is_above(element: &Element, frustum: &Frustum) -> bool {
    element.plane.is_some_and(|plane| frustum.heights(&plane)[0] > COINCIDENT * frustum.size())
}

/// Whether an element lies outside a frustum with the hull `points`, which does not touch it; false where that
/// is not certain.
fn is_outside(element: &Element, frustum: &Frustum, points: &[DVec3]) -> bool {
    let touching = COINCIDENT * frustum.size();
    is_above(element, frustum) || separated(&element.hull, &element.hull, points, -touching)
}
