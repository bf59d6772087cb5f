//! Errors of solutions that a grid of VTK cannot hold.

use radiosity_work::wording::{Wording, option, set, words};
use thiserror::Error;

/// Why a solution is no grid of polynomials.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum VtuError {
    /// Direct light goes through shadow masks.
    #[error("{}", self.message())]
    Masked,
    /// A polynomial of too high a degree.
    #[error(
        "surface '{surface}' carries polynomials of total degree {degree}; cells of VTK keep their digits up to {highest}"
    )]
    Degree {
        /// Name of the surface.
        surface: String,
        /// Total degree of the polynomial.
        degree: usize,
        /// The highest degree that is written.
        highest: usize,
    },
}

impl VtuError {
    /// The fault in words.
    pub fn message(&self) -> Wording {
        match self {
            Self::Masked => {
                words("direct light goes through shadow masks (")
                    + set("shadows", "mask")
                    + "), which are no polynomials"
            }
            Self::Degree { .. } => words(self.to_string()),
        }
    }

    /// The way to mend the fault, in words.
    pub fn cure(&self) -> Wording {
        match self {
            Self::Masked => words("solve with ") + set("shadows", "auto"),
            Self::Degree { .. } => {
                words("solve with an ")
                    + option("order")
                    + " of 10 at the most, or without "
                    + option("tensor")
            }
        }
    }
}
