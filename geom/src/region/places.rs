//! Things in a plane that are found by the boxes around them; few are looked at one by one.

use glam::DVec2;

use crate::{Aabb, Bvh};

/// So many things are looked at one by one. Chosen: a tree over the sides of a polygon of eight corners is no
/// faster than a loop over them; a larger number slows long outlines and plates with many holes.
const FEW: usize = 8;

/// The places of things, which their indices stand for.
#[derive(Clone, Debug)]
pub(super) struct Places {
    count: usize,
    tree: Option<Bvh>,
}

impl Places {
    /// The places of things that lie in `boxes`.
    pub(super) fn new(boxes: impl ExactSizeIterator<Item = Aabb>) -> Self {
        let count = boxes.len();
        let tree = (count > FEW).then(|| Bvh::build(&boxes.collect::<Vec<_>>()));
        Self { count, tree }
    }

    /// Whether `test` returns true for any of the things in boxes that pass `may_hold`, in no particular
    /// order; stops at the first. What a box fails has to be failed by every box inside it.
    pub(super) fn any(&self, may_hold: impl Fn(&Aabb) -> bool, mut test: impl FnMut(usize) -> bool) -> bool {
        match &self.tree {
            None => (0..self.count).any(test),
            Some(tree) => tree.search(may_hold).any(&mut test),
        }
    }

    /// The things whose boxes overlap `query`, and of few all, ascending.
    pub(super) fn near(&self, query: &Aabb) -> Vec<usize> {
        self.tree.as_ref().map_or_else(|| (0..self.count).collect(), |tree| tree.near(query))
    }
}

/// The smallest box around points of the plane.
pub(super) fn around(points: impl IntoIterator<Item = DVec2>) -> Aabb {
    Aabb::around(points.into_iter().map(|point| point.extend(0.0)))
}
