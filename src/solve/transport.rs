//! How pairs of elements are carried.

use serde::{Deserialize, Serialize};

/// How pairs of elements are carried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Transport {
    /// Exactly in small scenes, by rays in large ones.
    Auto,
    /// Every pair by the rules that keep the accuracy asked for.
    Exact,
    /// By rays that find the nearest surface.
    Sampled,
}
