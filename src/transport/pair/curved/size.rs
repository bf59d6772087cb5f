//! About how large a patch is.

use crate::elements::patch::Patch;

/// About the area of a patch.
pub(super) fn area(patch: &Patch) -> f64 {
    let nodes = patch.cell_nodes(2);
    nodes.iter().map(|x| x.area).sum::<f64>() / nodes.len() as f64
}
