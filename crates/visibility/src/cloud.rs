//! The corners of a scene's convex hulls: whether all of them lie on one side of a plane.

use radiosity_geom::{Aabb, Bvh, DVec3, Plane, touching};

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

    /// Whether no point rises higher than `h` over `plane`, which is tangent to a surface of this `extent`,
    /// by more than what touches.
    pub(super) fn lies_below(&self, h: f64, plane: &Plane, extent: f64) -> bool {
        let may_rise = |bounds: &Aabb| {
            let half = 0.5 * (bounds.max - bounds.min);
            plane.height(bounds.center()) + half.dot(plane.normal.abs()) > h + touching(extent, 0.0)
        };
        let rises = |x: DVec3| plane.height(x) > h + touching(extent, x.distance(plane.point));
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
            let plane = Plane { point: p, normal: n.normalize_or(DVec3::Z) };
            let top = points.iter().map(|x| plane.height(*x)).fold(f64::MIN, f64::max);
            let cloud = Cloud::new(points);
            prop_assert!(cloud.lies_below(top, &plane, 1.0));
            prop_assert!(cloud.lies_below(top - 0.9e-9, &plane, 1.0));
            prop_assert!(!cloud.lies_below(top - 1.1e-9, &plane, 1.0));
        }
    }
}
