//! Rays that leave an element: from points spread evenly over its area, in cosine-distributed directions.
//!
//! The density of points and directions together is cos θ / (π A), that of κ V dA_y over the whole
//! hemisphere. The numbers are a Kronecker sequence in four dimensions, shifted by a hash of a number of the
//! element, so that a ray depends on its element and its own number only: not on threads, nor on how many
//! rays are sent in all.

use radiosity_elements::Element;
use radiosity_elements::measure::WeightedNode;
use radiosity_elements::patch::Node;
use radiosity_elements::sampling::area_preserving_map::AreaPreservingMap;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::lambert::lambert;
use radiosity_elements::sampling::shift::{shift, shifted};
use radiosity_geom::DVec3;

/// The source of the rays of one element: points and directions from a shifted sequence.
#[derive(Debug)]
pub(super) struct Sender {
    area_map: AreaPreservingMap,
    shift: [f64; 4],
}

/// A ray as it leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Departure {
    /// The point where the ray starts.
    pub node: Node,
    /// The ray's unit direction.
    pub direction: DVec3,
    /// Weight of the point where it starts ([`WeightedNode::weight`]).
    pub weight: f64,
}

impl Sender {
    /// The sender of an element; its rays are those of this number.
    pub(super) fn new(element: &Element, number: u64) -> Self {
        Self { area_map: AreaPreservingMap::over(element), shift: shift(number) }
    }

    /// The ray of that `index`.
    pub(super) fn departure(&self, index: u64) -> Departure {
        let [s, t, polar, turn] = shifted(kronecker::point(index), &self.shift);
        let WeightedNode { node, weight } = self.area_map.point([s, t]);
        Departure { node, direction: lambert(node.normal, [polar, turn]), weight }
    }
}
