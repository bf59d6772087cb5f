//! Segments that are found by the boxes that they reach into.

use radiosity_geom::{Aabb, Bvh, DVec3};

/// Segments in space.
pub(super) struct Segments {
    /// Start and end of each.
    pub(super) list: Vec<[DVec3; 2]>,
    tree: Bvh,
}

impl Segments {
    pub(super) fn new(list: Vec<[DVec3; 2]>) -> Self {
        let boxes: Vec<Aabb> = list.iter().map(|ends| Aabb::around(*ends)).collect();
        Segments { list, tree: Bvh::build(&boxes) }
    }

    /// The indices of the segments that may come within `room` of all points between `points`, ascending.
    pub(super) fn near(&self, points: impl IntoIterator<Item = DVec3>, room: f64) -> Vec<usize> {
        self.tree.near(&Aabb::around(points).inflate(room))
    }
}
