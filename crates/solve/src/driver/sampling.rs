//! Cost and error of the sampled transport of a solution.

use serde::{Deserialize, Serialize};

/// Cost and error of the sampled transport of a solution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sampling {
    /// Number of rays sent.
    pub rays: u64,
    /// Rays that were to be sent; fewer are, where the work was stopped.
    pub planned: u64,
    /// Pairs of elements that were carried exactly beside them.
    pub exact_pairs: usize,
    /// Estimate of the relative error that rays, and exact pairs, leave: L2 over the elements of their mean
    /// irradiance, largest of the bands and light groups. None where half the rays are too few for a
    /// solution.
    pub error: Option<f64>,
}
