//! Approximate size of a patch.

use crate::elements::patch::{Direction, Patch};

/// Approximate area of a patch, by 2 × 2 points.
pub(super) fn area(patch: &Patch) -> f64 {
    let nodes = patch.cell_nodes(2);
    nodes.iter().map(|x| x.area).sum::<f64>() / nodes.len() as f64
}

/// The direction of the larger extent, and that extent.
pub(super) fn longest(patch: &Patch) -> (Direction, f64) {
    let [along, across] = patch.extents();
    if along >= across { (Direction::Along, along) } else { (Direction::Across, across) }
}
