//! Kinds of shadows, and their accuracy.

use serde::{Deserialize, Serialize};

/// Accuracy of exact shadows over that of the transfers: errors of shadows have one sign and add up in rows,
/// while errors of rules have either sign. A quarter lets four shadowed blocks of a row err together as much
/// as one block by rules. With a smaller value shadows take most of the time.
const EXACT: f64 = 0.25;

/// Whether and how surfaces hide each other, with the accuracy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shadows {
    /// No shadows: nothing hides anything.
    Off,
    /// Rays against the candidate blockers of each pair. A curved blocker that reaches into the shaft by less
    /// than this part of the narrower patch's breadth is ignored: it hides at most about that part of the
    /// light between them.
    Rays(f64),
    /// Planar blockers by their outlines if at least one of the two surfaces is planar, all else as for
    /// `Rays`.
    Outlines(f64),
}

/// Kind of shadows, as the user chooses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Hiding {
    /// No shadows.
    Off,
    /// Rays wherever something may stand between.
    Rays,
    /// Planar blockers by their outlines, all others by rays.
    #[default]
    Auto,
    /// As [`Hiding::Auto`], to the accuracy of the transfers.
    Exact,
}

impl Hiding {
    /// Accuracy of the shadows for transfers of accuracy `eps`, if `shadow_eps` is asked for.
    pub fn accuracy(self, eps: f64, shadow_eps: f64) -> f64 {
        if self == Self::Exact { shadow_eps.min(EXACT * eps) } else { shadow_eps }
    }

    /// The shadows of this mode to the accuracy `eps`.
    pub fn shadows(self, eps: f64) -> Shadows {
        match self {
            Self::Off => Shadows::Off,
            Self::Rays => Shadows::Rays(eps),
            Self::Auto | Self::Exact => Shadows::Outlines(eps),
        }
    }
}
