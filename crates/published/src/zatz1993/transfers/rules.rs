//! The rules of the paper, and the readings of its eq. 27.

use serde::{Deserialize, Serialize};

/// Which of the paper's rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PaperRules {
    /// Gauss–Legendre points for every pair (eq. 26).
    Legendre,
    /// Gauss–Jacobi points for pairs with a common edge (eq. 27), Gauss–Legendre for all others.
    Hybrid(HybridReading),
}

/// Reading of eq. 27; see the module `transfers`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HybridReading {
    /// Weight (1 − s²)² (1 + t)², Gauss–Legendre points on the emitter: nearest to the paper's numbers.
    H1,
    /// Weight (1 + t)², Gauss–Jacobi points on the emitter with the weight divided out: nearest to the
    /// paper's text.
    H2,
    /// Weight (1 + t)², Gauss–Legendre points on the emitter.
    H3,
    /// The weight as printed, not divided out on the emitter: wrong, whatever the number of points.
    Literal,
}

impl PaperRules {
    /// Points per direction above the order that reproduce the numbers of the paper.
    pub const fn extra_points(self) -> usize {
        match self {
            Self::Hybrid(HybridReading::H2) => 3,
            Self::Legendre | Self::Hybrid(_) => 2,
        }
    }
}

impl HybridReading {
    /// Exponents (α, β) of the receiver's weight (1 − s)^α (1 + s)^β along the edge.
    pub(super) const fn along(self) -> [u8; 2] {
        match self {
            Self::H1 => [2, 2],
            Self::H2 | Self::H3 | Self::Literal => [0, 0],
        }
    }
}
