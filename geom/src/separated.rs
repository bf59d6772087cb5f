//! Whether anything can stand between two patches.
//!
//! A segment from a point of A to a point of B lies in the convex hull of A ∪ B. So if a plane has that hull
//! on one side and C on the other, C hides nothing between A and B. A plane of normal d separates exactly if
//! d · w ≥ 0 for all differences w = c − x, c ∈ C, x ∈ A ∪ B. These half-spaces meet in a convex cone of
//! directions, seen through the six faces of the cube |d|_∞ = 1: on each face the cone is a convex polygon.
//! The face is clipped by the half-space that the middle of what remains misses most, until it misses none,
//! and separates, or nothing is left. Touching hulls leave a cone of no width, so each half-space is moved
//! outwards by the tolerance: d · w ≥ −τ.

use std::iter;

use glam::DVec3;
use smallvec::SmallVec;

use crate::clip_by_heights;

/// Directions: a convex polygon on a face of the cube.
type Cone = SmallVec<[DVec3; 12]>;

/// True only if the convex hull of `a` ∪ `b` certainly does not properly meet the convex hull of `c`: there
/// is a plane that neither crosses by more than `tolerance` (a length). Touching hulls count as separated.
///
/// Meant for the few corners of patches and boxes: usually a few clips, each after a pass over all points,
/// and never more than |c| · (|a| + |b|) per face.
pub fn separated(a: &[DVec3], b: &[DVec3], c: &[DVec3], tolerance: f64) -> bool {
    separating(a, b, c, tolerance).is_some()
}

/// Whether a plane of this normal tells what [`separated`] does.
pub fn separates(d: DVec3, [a, b, c]: [&[DVec3]; 3], tolerance: f64) -> bool {
    d != DVec3::ZERO && gap(a, b, c, d) >= -tolerance * d.length()
}

/// A normal of a plane that tells what [`separated`] does, if there is one.
pub fn separating(a: &[DVec3], b: &[DVec3], c: &[DVec3], tolerance: f64) -> Option<DVec3> {
    let splits = |d: &DVec3| separates(*d, [a, b, c], tolerance);
    let middle = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len() as f64;
    let towards = middle(c) - 0.5 * (middle(a) + middle(b));
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|d| [d, -d]);
    if let Some(d) = iter::once(towards).chain(axes).find(splits) {
        return Some(d);
    }
    // The faces that look along what separates the middles are the most likely to hold a direction.
    let [x, y, z] = towards.abs().to_array();
    let by_height = match (x >= y, y >= z, x >= z) {
        (true, true, _) => [0, 1, 2],
        (true, false, true) => [0, 2, 1],
        (true, false, false) => [2, 0, 1],
        (false, true, true) => [1, 0, 2],
        (false, true, false) => [1, 2, 0],
        (false, false, _) => [2, 1, 0],
    };
    let along = by_height.map(|axis| if towards[axis] < 0.0 { axis + 3 } else { axis });
    let faces = along.into_iter().chain(along.into_iter().rev().map(|face| (face + 3) % 6));
    faces.into_iter().find_map(|face| direction_on(face, [a, b, c], tolerance).filter(splits))
}

/// The width of the slab of normal `d` with A ∪ B below and C above, times |d|; negative where they overlap.
fn gap(a: &[DVec3], b: &[DVec3], c: &[DVec3], d: DVec3) -> f64 {
    -farthest(c, -d).0 - farthest(a, d).0.max(farthest(b, d).0)
}

/// A direction within one face of the cube of directions that separates, if there is one.
fn direction_on(face: usize, [a, b, c]: [&[DVec3]; 3], tolerance: f64) -> Option<DVec3> {
    let mut cone = cube_face(face);
    let mut next = Cone::new();
    let middle = |cone: &[DVec3]| cone.iter().sum::<DVec3>() / cone.len() as f64;
    for _ in 0..c.len() * (a.len() + b.len()) {
        let d = middle(&cone);
        let (first, second) = (farthest(a, d), farthest(b, d));
        let (top, x) = if second.0 > first.0 { second } else { first };
        let (bottom, y) = farthest(c, -d);
        if top + bottom <= tolerance {
            return Some(d);
        }
        let heights: SmallVec<[f64; 12]> = cone.iter().map(|d| d.dot(y - x) + tolerance).collect();
        next.clear();
        clip_by_heights(&cone, &heights, |d| next.push(d));
        std::mem::swap(&mut cone, &mut next);
        if cone.is_empty() {
            return None;
        }
    }
    Some(middle(&cone))
}

/// Largest d·x of the points x, and the point that has it.
fn farthest(points: &[DVec3], d: DVec3) -> (f64, DVec3) {
    let mut best = (f64::NEG_INFINITY, DVec3::ZERO);
    for x in points {
        let reach = d.dot(*x);
        if reach > best.0 {
            best = (reach, *x);
        }
    }
    best
}

/// The square |d|_∞ = 1 with one coordinate fixed to +1 (faces 0-2) or −1 (faces 3-5).
fn cube_face(face: usize) -> Cone {
    let axis = face % 3;
    let sign = if face < 3 { 1.0 } else { -1.0 };
    let corner = |(p, q): (f64, f64)| {
        let mut d = DVec3::ZERO;
        (d[axis], d[(axis + 1) % 3], d[(axis + 2) % 3]) = (sign, p, q);
        d
    };
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(corner).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn square(center: DVec3, u: DVec3, v: DVec3) -> [DVec3; 4] {
        [center - u - v, center + u - v, center + u + v, center - u + v]
    }

    #[test]
    fn walls_touch_but_do_not_hide() {
        let floor = square(DVec3::ZERO, DVec3::X, DVec3::Y);
        let ceiling = square(2.0 * DVec3::Z, DVec3::X, DVec3::Y);
        let wall = square(DVec3::X + DVec3::Z, DVec3::Y, DVec3::Z);
        assert!(separated(&floor, &ceiling, &wall, 1e-9));
        let blind = square(DVec3::Z, 0.1 * DVec3::X, 0.1 * DVec3::Y);
        assert!(!separated(&floor, &ceiling, &blind, 1e-9));
        let leaning = square(DVec3::X + DVec3::Z, DVec3::Y, DVec3::Z + 1e-3 * DVec3::X);
        assert!(!separated(&floor, &ceiling, &leaning, 1e-9));
    }

    #[test]
    fn neighbours_at_a_vertex_are_separated() {
        let floor = square(DVec3::ZERO, DVec3::X, DVec3::Y);
        let roof = [DVec3::new(-1.0, -1.0, 1.0), DVec3::new(1.0, -1.0, 1.0), DVec3::new(0.0, 1.0, 3.0)];
        let tip = DVec3::new(1.0, 1.0, 0.0);
        let outside = [tip, tip + DVec3::X, tip + DVec3::Y + 0.2 * DVec3::Z];
        assert!(separated(&floor, &roof, &outside, 1e-9));
    }

    proptest! {
        /// A triangle pushed to just touch the far side of a plane is separated; pushed through, a segment
        /// meets it.
        #[test]
        fn separation_is_decided_either_way(
            points in prop::collection::vec((-1.0..1.0, -1.0..1.0, 0.01..1.0), 9),
            weights in (0.05..1.0, 0.05..1.0, 0.05..1.0),
            sink in 0.1..0.5,
        ) {
            let p: Vec<DVec3> = points.iter().map(|&(x, y, z)| DVec3::new(x, y, z)).collect();
            let (a, b) = (&p[..3], &p[3..6]);
            let below: Vec<DVec3> = p[6..].iter().map(|x| *x * DVec3::new(1.0, 1.0, -1.0)).collect();
            prop_assert!(separated(a, b, &below, 1e-9));
            // The triangle through the middle of a segment from A to B, by construction inside the hull.
            let sum = weights.0 + weights.1 + weights.2;
            let inside = |q: &[DVec3]| -> DVec3 { (weights.0 * q[0] + weights.1 * q[1] + weights.2 * q[2]) / sum };
            let middle = inside(a).lerp(inside(b), sink);
            let flat = (a[1] - a[0]).cross(a[2] - a[0]).dot(b[0] - a[0]).abs() < 1e-3;
            prop_assume!(!flat);
            let pierced = [middle + DVec3::X, middle - DVec3::X + DVec3::Y, middle - DVec3::X - DVec3::Y];
            prop_assert!(!separated(a, b, &pierced, 1e-9));
        }
    }
}
