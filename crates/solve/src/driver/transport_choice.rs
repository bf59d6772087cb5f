//! The carriers of pairs of elements: exact blocks, or rays.

use serde::{Deserialize, Serialize};

/// Rays for each surface, and in all at least, at the default accuracy of shadows. From two real rooms (soda
/// shop, classroom): 3 % of the light gathered at points.
const RAYS_PER_SURFACE: u64 = 250;
const FEWEST_RAYS: u64 = 400_000;

/// Most rays of a run: more than an hour's on two cores.
pub const MOST_RAYS: u64 = 4_000_000_000;

/// Accuracy of shadows for which these are the numbers of rays.
pub(super) const USUAL_ACCURACY: f64 = 3e-3;

/// Part of the usual rays that is sent even where any accuracy would do: three times their noise. With fewer
/// rays many pairs of elements would get none.
const LEAST_PART: f64 = 0.125;

/// Carriers of pairs of elements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Transport {
    /// Exactly where that costs no more than as good an answer by rays, from what is known of the pairs
    /// beforehand; by rays elsewhere.
    #[default]
    Auto,
    /// Every pair to the accuracy asked for.
    Exact,
    /// By rays that find the nearest surface; the error is estimated from their two halves.
    Sampled,
}

/// A choice of transport, and why it was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TransportChoice {
    /// Whether rays carry the pairs.
    pub sampled: bool,
    /// The reason, in a few words.
    pub why: String,
}

/// Rays for a scene of so many surfaces whose shadows are wanted to the accuracy `shadow_eps`.
pub(super) fn usual_rays(surfaces: usize, shadow_eps: f64) -> u64 {
    let usual = (RAYS_PER_SURFACE * surfaces as u64).max(FEWEST_RAYS);
    (usual as f64 * (USUAL_ACCURACY / shadow_eps).max(LEAST_PART)).ceil() as u64
}
