//! Which element of a pair may be the outer one of a shadow by outlines where cans, cones and disks stand
//! between.
//!
//! The inner element is a polygon, a disk or a ring, and all frusta lie on its front: then all of it within the cone
//! over their outlines is hidden from before it. They may stand on it, but not touch it at a point or along a
//! generator: there outlines are tangent to its sides from wherever they are seen. The outer element lies outside of
//! all frusta and touches none: what a lid in its plane hides would jump along the rim. Before disks and rings it is
//! planar, and both lie wholly before each other, so that no horizon cuts their rims.

use radiosity_elements::Element;
use radiosity_geom::{COINCIDENT, DVec3, Meridian, Plane, ROUNDING, Rect, separated};
use radiosity_visibility::Visibility;
use radiosity_visibility::frustum::Frustum;

/// Whether each element of a pair may be the outer one, past `blockers`: the other is a polygon, a disk or a ring.
pub(crate) fn outer_sides(pair: [&Element; 2], blockers: &[usize], visibility: &Visibility) -> [bool; 2] {
    let may_be_outer = |outer: usize| {
        let (own, other) = (pair[outer], pair[1 - outer]);
        let mut frusta =
            blockers.iter().filter_map(|own| Some((visibility.frustum(*own)?, visibility.hull(*own))));
        (other.plane.is_some() || is_round_window(other, own, blockers, visibility))
            && frusta.all(|(frustum, hull)| is_before(other, frustum) && is_outside(own, frustum, hull))
    };
    [0, 1].map(may_be_outer)
}

/// The meridian of an element that is a disk or a ring.
pub(crate) fn disk_meridian(element: &Element, visibility: &Visibility) -> Option<Meridian> {
    let meridian = visibility.meridian(element.surface)?.part(element.rect.v);
    (element.is_cell() && element.rect.u == Rect::FULL.u && element.level.is_some()).then_some(meridian)
}

/// Whether an element is a disk or a ring before which another one and frusta lie.
fn is_round_window(own: &Element, other: &Element, blockers: &[usize], visibility: &Visibility) -> bool {
    let ends = [own, other].map(|element| Some((element.level?, &element.hull[..])));
    disk_meridian(own, visibility).is_some()
        && blockers.iter().all(|blocker| visibility.frustum(*blocker).is_some())
        && lie_before_each_other(ends)
}

/// Whether two planar things, given by plane and hull, lie wholly before each other.
fn lie_before_each_other([first, second]: [Option<(Plane, &[DVec3])>; 2]) -> bool {
    let Some(((a, a_hull), (b, b_hull))) = first.zip(second) else { return false };
    let is_before = |plane: Plane, hull: &[DVec3]| {
        let size = hull.iter().map(|x| x.distance(hull[0])).fold(0.0, f64::max);
        hull.iter().all(|x| plane.height(*x) >= -COINCIDENT * size)
    };
    is_before(a, b_hull) && is_before(b, a_hull)
}

/// For each surface, whether it is best left uncut, as what cans, cones and disks hide of it has a closed form: disks
/// and rings that see each other past them alone.
pub(crate) fn best_whole(visibility: &Visibility, surfaces: usize) -> Vec<bool> {
    let disk = |surface: usize| Some((surface, level(&visibility.meridian(surface)?)?));
    let disks: Vec<(usize, Plane)> = (0..surfaces).filter_map(disk).collect();
    let mut are_whole = vec![false; surfaces];
    for (place, (first, a)) in disks.iter().enumerate() {
        for (second, b) in &disks[place + 1..] {
            let pair @ [one, other] = [*first, *second];
            let [p, q] = pair.map(|surface| visibility.hull(surface));
            if lie_before_each_other([Some((*a, p)), Some((*b, q))])
                && are_past_frusta(pair, &visibility.candidates(p, q, pair), visibility)
            {
                (are_whole[one], are_whole[other]) = (true, true);
            }
        }
    }
    are_whole
}

/// Whether cans, cones and disks alone, and some, may stand between two surfaces, and no line meets two of them.
fn are_past_frusta(pair: [usize; 2], blockers: &[usize], visibility: &Visibility) -> bool {
    let bodies = visibility.one_of_each_body(blockers);
    !blockers.is_empty()
        && blockers.iter().all(|blocker| visibility.frustum(*blocker).is_some())
        && pair.iter().all(|own| are_apart(visibility.hull(*own), &bodies, visibility))
}

/// The plane of a disk or a ring, facing its front.
fn level(meridian: &Meridian) -> Option<Plane> {
    let Meridian { origin, axis, ends, normal } = *meridian;
    let is_level = (ends[0].y - ends[1].y).abs() <= ROUNDING * meridian.size();
    is_level.then(|| Plane { point: origin + ends[0].y * axis, normal: normal.y * axis })
}

/// Whether cans, cones or disks are among `blockers`.
pub(crate) fn have_frusta(blockers: &[usize], visibility: &Visibility) -> bool {
    blockers.iter().any(|own| visibility.frustum(*own).is_some())
}

/// Whether all `blockers` are frusta or balls.
pub(crate) fn are_round(blockers: &[usize], visibility: &Visibility) -> bool {
    blockers.iter().all(|own| visibility.frustum(*own).is_some() || visibility.ball(*own).is_some())
}

/// Whether shadows of `bodies` can be summed: all are frusta or balls, and no line from within the hull of `outer`
/// meets two of them.
pub(crate) fn are_apart(outer: &[DVec3], bodies: &[usize], visibility: &Visibility) -> bool {
    // The nearer one of two would lie between the element and the other.
    let comes_before = |near: usize, far: usize| {
        near != far && !separated(outer, visibility.hull(far), visibility.hull(near), 0.0)
    };
    are_round(bodies, visibility)
        && !bodies.iter().any(|near| bodies.iter().any(|far| comes_before(*near, *far)))
}

/// Whether all of a frustum lies on the front of a polygon or a disk, and touches it by a lid at the most.
fn is_before(element: &Element, frustum: &Frustum) -> bool {
    let stands = |level: Plane| frustum.stands_on(&level) && frustum.heights(&level)[1] > 0.0;
    is_above(element, frustum) || element.level.is_some_and(stands)
}

/// Whether all of a frustum lies above the plane of an element.
fn is_above(element: &Element, frustum: &Frustum) -> bool {
    element.level.is_some_and(|level| frustum.heights(&level)[0] > COINCIDENT * frustum.size())
}

/// Whether an element lies outside a frustum with the hull `points`, which does not touch it; false where that
/// is not certain.
fn is_outside(element: &Element, frustum: &Frustum, points: &[DVec3]) -> bool {
    let touching = COINCIDENT * frustum.size();
    is_above(element, frustum) || separated(&element.hull, &element.hull, points, -touching)
}
