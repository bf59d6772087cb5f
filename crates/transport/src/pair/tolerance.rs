//! The errors that the block of one pair may have.

use radiosity_kernel::Accuracy;

/// The errors that the block of a pair may have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance {
    /// Relative to the block's first entry, or to `least` where that is larger.
    pub accuracy: Accuracy,
    /// Standard deviation that sampled shadows may make in an entry.
    pub shadow_error: f64,
    /// Entry below which the errors of a pair with a curved element are measured no finer.
    pub least: f64,
    /// About the largest entry of the block's row: the smaller the block of a pair with a curved element
    /// compared with it, the less contacts and horizons are refined.
    pub row: f64,
}
