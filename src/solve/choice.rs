//! How pairs of elements are carried: exactly, or by rays.
//!
//! Exact blocks cost about the square of the number of elements, and most where things hide each other; rays cost
//! about that number,
//! whatever stands between. An office of 430 polygons took 94 s of CPU exactly, 33 000 of its 37 000 pairs partly
//! hidden, and 1 s by
//! rays with a smaller error of the light gathered at points; rooms of a hundred surfaces are done exactly in seconds,
//! to an error that
//! rays would take minutes for.

use serde::{Deserialize, Serialize};

/// Most surfaces of a scene that is carried exactly by default. Chosen between the rooms above.
const FEW: usize = 300;

/// Rays for each surface, and in all at least, at the default accuracy of shadows. From two real rooms (soda shop,
/// classroom): 3 % of the
/// light gathered at points.
const RAYS_PER_SURFACE: u64 = 250;
const FEWEST_RAYS: u64 = 400_000;

/// Most rays of a run: more than an hour's on two cores.
pub const MOST_RAYS: u64 = 4_000_000_000;

/// Accuracy of shadows for which these are the numbers of rays.
const USUAL_ACCURACY: f64 = 3e-3;

/// How pairs of elements are carried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Transport {
    /// Exactly in scenes of up to 300 surfaces, by rays in larger ones.
    #[default]
    Auto,
    /// Every pair to the accuracy asked for.
    Exact,
    /// By rays that find the nearest surface; the error is estimated from their two halves.
    Sampled,
}

/// A choice of transport, and why it was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Choice {
    /// Whether rays carry the pairs.
    pub sampled: bool,
    /// The reason, in a few words.
    pub why: String,
}

impl Transport {
    /// What carries the pairs of a scene of so many surfaces, given whether a number of rays is asked for.
    pub(super) fn choice(self, surfaces: usize, has_rays: bool) -> Choice {
        let (sampled, why) = match self {
            Self::Exact => (false, "asked for".to_owned()),
            Self::Sampled => (true, "asked for".to_owned()),
            Self::Auto if has_rays => (true, "a number of rays is given".to_owned()),
            Self::Auto if surfaces <= FEW => (false, format!("{surfaces} surfaces, not more than {FEW}")),
            Self::Auto => (true, format!("{surfaces} surfaces, more than {FEW}")),
        };
        Choice { sampled, why }
    }
}

/// Rays for a scene of so many surfaces whose shadows are wanted to the accuracy `shadow_eps`.
pub(super) fn usual_rays(surfaces: usize, shadow_eps: f64) -> u64 {
    let usual = (RAYS_PER_SURFACE * surfaces as u64).max(FEWEST_RAYS);
    (usual as f64 * (USUAL_ACCURACY / shadow_eps).sqrt()).ceil() as u64
}
