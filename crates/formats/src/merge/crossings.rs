//! Whether the sides of loops in a plane cross or touch other than at common corners.

use glam::DVec2;
use radiosity_geom::{Aabb, Bvh, sides};

/// Pairs of sides that are compared at least before loops count as crossing: a million take some
/// milliseconds.
const LEAST: usize = 1_000_000;
/// Pairs that are compared for each side before loops count as crossing: boundaries of real meshes take a
/// few, and the time of others would grow with the square of their sides.
const FOR_EACH: usize = 100;

/// Whether two sides of `loops` without a common corner come as near to each other as `near`. True too where
/// the answer would take too long.
pub(super) fn cross(loops: &[Vec<DVec2>], near: f64) -> bool {
    let sides: Vec<[DVec2; 2]> = loops.iter().flat_map(|ring| sides(ring)).collect();
    let around = |side: &[DVec2; 2]| Aabb::around(side.map(|x| x.extend(0.0)));
    let boxes: Vec<Aabb> = sides.iter().map(around).collect();
    let tree = Bvh::build(&boxes);
    let mut budget = LEAST.max(FOR_EACH * sides.len());
    sides.iter().zip(&boxes).enumerate().any(|(own, (side, bounds))| {
        let reach = bounds.inflate(near);
        tree.search(|bounds| bounds.overlaps(&reach)).filter(|other| *other > own).any(|other| {
            budget -= 1;
            budget == 0 || meet(*side, sides[other], near)
        })
    })
}

/// Whether two sides without a common corner cross, or an end of one is as near to the other as `near`.
fn meet(one: [DVec2; 2], other: [DVec2; 2], near: f64) -> bool {
    if one.iter().any(|end| other.contains(end)) {
        return false;
    }
    let touches = |side: [DVec2; 2], ends: [DVec2; 2]| ends.iter().any(|end| distance(side, *end) <= near);
    let parts = |[a, b]: [DVec2; 2], ends: [DVec2; 2]| {
        let [x, y] = ends.map(|end| (b - a).perp_dot(end - a));
        (x < 0.0) != (y < 0.0)
    };
    touches(one, other) || touches(other, one) || (parts(one, other) && parts(other, one))
}

/// Distance of a point from a side.
fn distance([a, b]: [DVec2; 2], point: DVec2) -> f64 {
    let along = (point - a).dot(b - a) / a.distance_squared(b);
    a.lerp(b, along.clamp(0.0, 1.0)).distance(point)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(points: &[[f64; 2]]) -> Vec<DVec2> {
        points.iter().map(|x| DVec2::from_array(*x)).collect()
    }

    #[test]
    fn a_bow_crosses_itself_and_a_square_does_not() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(!cross(&[ring(&square)], 1e-6));
        assert!(cross(&[ring(&bow)], 1e-6));
    }

    #[test]
    fn a_hole_that_leaves_its_outline_crosses() {
        let square = ring(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
        let hole = |x: f64| ring(&[[x, 1.0], [x, 2.0], [x + 1.0, 2.0], [x + 1.0, 1.0]]);
        assert!(!cross(&[square.clone(), hole(1.0)], 1e-6));
        assert!(cross(&[square.clone(), hole(3.5)], 1e-6));
        assert!(cross(&[square, hole(3.0)], 1e-6), "its side lies on the outline");
    }
}
