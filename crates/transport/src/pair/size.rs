//! Approximate size of a patch.

use radiosity_elements::patch::Patch;

/// Approximate area of a patch, by 2 × 2 points.
pub(super) fn area(patch: &Patch) -> f64 {
    let nodes = patch.cell_nodes(2);
    nodes.iter().map(|x| x.area).sum::<f64>() / nodes.len() as f64
}
