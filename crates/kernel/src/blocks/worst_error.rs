//! Largest error of a block by rules or rays, against what was asked.

use serde::{Deserialize, Serialize};

/// The error of the block of two elements that misses most of what was asked.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct WorstError {
    /// The two elements; in view factors the two surfaces.
    pub pair: [usize; 2],
    /// By rules of an entry, relative to the largest of: the block's largest entry, a hundredth of its row's,
    /// and 1e-8; by rays of the view factors of either element, relative to the largest of its row.
    pub error: f64,
    /// The error that was asked for.
    pub asked: f64,
    /// Whether rays carried the block.
    pub by_rays: bool,
}

impl WorstError {
    /// Whether the error is larger than asked.
    pub fn is_real(&self) -> bool {
        self.error > self.asked
    }

    /// Error over what was asked.
    pub(super) fn excess(&self) -> f64 {
        self.error / self.asked
    }
}
