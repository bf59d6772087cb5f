//! What a grid of VTK cannot hold.

use thiserror::Error;

/// Why a solution is no grid of polynomials.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum VtuError {
    /// Direct light goes through shadow masks.
    #[error("direct light goes through shadow masks (--shadows mask), which are no polynomials")]
    Masked,
    /// A polynomial of too high a degree.
    #[error(
        "surface '{surface}' carries polynomials of total degree {degree}; cells of VTK keep their digits up to {highest}"
    )]
    Degree {
        /// Name of the surface.
        surface: String,
        /// Its total degree.
        degree: usize,
        /// The highest degree that is written.
        highest: usize,
    },
}

impl VtuError {
    /// How to mend it.
    pub fn cure(&self) -> &'static str {
        match self {
            Self::Masked => "solve with --shadows auto",
            Self::Degree { .. } => "solve with an --order of 10 at the most, or without --tensor",
        }
    }
}
