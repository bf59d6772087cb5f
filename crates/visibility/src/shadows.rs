//! Ways to find shadows.

use serde::{Deserialize, Serialize};

/// Accuracy of exact shadows over that of the transfers: errors of shadows have one sign and add up in rows,
/// while errors of rules have either sign. A quarter lets four shadowed blocks of a row err together as much
/// as one block by rules. With a smaller value shadows take most of the time.
const EXACT: f64 = 0.25;

/// Ways to find out what surfaces hide from each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Shadows {
    /// Shadows of planar surfaces, balls, cans, cones and disks, on planar ones and within spheres, by outlines,
    /// all else by rays
    #[default]
    Auto,
    /// Nothing hides anything
    Off,
    /// Rays where something can stand between
    Rays,
    /// As auto, but to the accuracy --eps
    Exact,
}

impl Shadows {
    /// Accuracy of the shadows for transfers of accuracy `eps`, if `shadow_eps` is asked for.
    pub fn accuracy(self, eps: f64, shadow_eps: f64) -> f64 {
        if self == Self::Exact { shadow_eps.min(EXACT * eps) } else { shadow_eps }
    }
}
