//! The corners of a scene's convex hulls: whether all of them lie on one side of a plane.

use radiosity_geom::{Aabb, Bvh, DVec3, touching};

/// The points in whose convex hull a scene lies.
#[derive(Debug)]
pub(super) struct Cloud {
    points: Vec<DVec3>,
    tree: Bvh,
}

impl Cloud {
    pub(super) fn new(points: Vec<DVec3>) -> Self {
        let boxes: Vec<Aabb> = points.iter().map(|x| Aabb { min: *x, max: *x }).collect();
        Self { tree: Bvh::build(&boxes), points }
    }

    /// Whether no point rises above the plane (x − p) · n = h by more than what touches it, for the point `p`
    /// and unit normal `n` of a surface of this `extent`.
    pub(super) fn lies_below(&self, h: f64, [p, n]: [DVec3; 2], extent: f64) -> bool {
        let may_rise = |bounds: &Aabb| {
            let half = 0.5 * (bounds.max - bounds.min);
            (bounds.center() - p).dot(n) + half.dot(n.abs()) > h + touching(extent, 0.0)
        };
        let rises = |x: DVec3| (x - p).dot(n) > h + touching(extent, x.distance(p));
        !self.tree.search(may_rise).any(|index| rises(self.points[index]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn place() -> impl Strategy<Value = DVec3> {
        [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(DVec3::from_array)
    }

    proptest! {
        #[test]
        fn the_highest_point_decides(points in prop::collection::vec(place(), 1..200), p in place(), n in place()) {
            let n = n.normalize_or(DVec3::Z);
            let top = points.iter().map(|x| (*x - p).dot(n)).fold(f64::MIN, f64::max);
            let cloud = Cloud::new(points);
            prop_assert!(cloud.lies_below(top, [p, n], 1.0));
            prop_assert!(cloud.lies_below(top - 0.9e-9, [p, n], 1.0));
            prop_assert!(!cloud.lies_below(top - 1.1e-9, [p, n], 1.0));
        }
    }
}
