//! How shadows are found, and to what accuracy.

use serde::{Deserialize, Serialize};

/// Errors of exact shadows relative to those of the transfers: they have one sign where those of rules have either, and add
/// up in rows.
const EXACT: f64 = 0.25;

/// Whether surfaces hide each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shadows {
    /// Everything sees everything it faces.
    Off,
    /// Rays against the candidates of each pair. A curved blocker that reaches into the shaft of a pair by less
    /// than this part of the breadth of the narrower of the two is passed over: it hides about that part
    /// of the light between them at the most.
    Rays(f64),
    /// The same, but planar surfaces behind planar blockers by their outlines.
    Outlines(f64),
}

/// How it is found out what surfaces hide from each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Hiding {
    /// Nothing hides anything.
    Off,
    /// Rays wherever something can stand between.
    Rays,
    /// Planar surfaces behind planar blockers by their outlines, all else by rays.
    #[default]
    Auto,
    /// The same, to the accuracy of the transfers.
    Exact,
}

impl Hiding {
    /// Accuracy of visibility within a transfer of accuracy `eps`, where `shadow_eps` is asked for.
    pub fn accuracy(self, eps: f64, shadow_eps: f64) -> f64 {
        if self == Self::Exact { shadow_eps.min(EXACT * eps) } else { shadow_eps }
    }

    /// The shadows of this kind to the accuracy `eps`.
    pub fn shadows(self, eps: f64) -> Shadows {
        match self {
            Self::Off => Shadows::Off,
            Self::Rays => Shadows::Rays(eps),
            Self::Auto | Self::Exact => Shadows::Outlines(eps),
        }
    }
}
