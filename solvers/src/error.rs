//! Why a system was not solved, and the cure.

use std::fmt;

/// Reason for which an iteration ended before it reached its tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The allowed number of iterations was used up.
    Iterations,
    /// As many shots as were asked for are made.
    Shots,
    /// The time budget was used up.
    Time,
    /// The residual no longer falls: the tolerance is below what rounding leaves, or the method is stuck.
    Stagnation,
    /// The residual grows: the matrix lacks what the method needs.
    Divergence,
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Iterations => "allow more iterations, or take a direct method",
            Self::Shots => "allow more shots, or do not limit them",
            Self::Time => "time is up: allow more of it, or ask for less accuracy",
            Self::Stagnation => {
                "the residual no longer falls: ask for less accuracy, or take a direct method"
            }
            Self::Divergence => "the residual grows: take gmres or a direct method",
        })
    }
}

/// Why a system was not solved.
///
/// Whatever the variant, the vector of unknowns then holds the best iterate there was.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SolveError {
    /// The wanted residual was not reached.
    #[error("{method} {}, wanted {tolerance:.2e}; {stop}", progress(*iterations, *residual))]
    NotConverged {
        /// Name of the method.
        method: &'static str,
        /// Iterations done; refinement steps for a direct method.
        iterations: usize,
        /// ‖b − A x‖₂ / ‖b‖₂ of the returned x, recomputed; infinite if none was computed yet.
        residual: f64,
        /// The residual that was asked for.
        tolerance: f64,
        /// Reason for which the iteration ended.
        stop: Stop,
    },
    /// The matrix, or a diagonal block the method must invert, has no inverse in double precision.
    #[error(
        "{what} is singular to working precision; look for equations that repeat or unknowns that none holds"
    )]
    Singular {
        /// "the matrix", or the diagonal block by number.
        what: String,
    },
    /// The method needs A = Aᵀ.
    #[error("{method} needs a symmetric matrix; take gmres, lu or gauss-seidel, or symmetrise the system")]
    NotSymmetric {
        /// Name of the method.
        method: &'static str,
    },
    /// The method needs xᵀ A x > 0 for every x ≠ 0.
    #[error("{method} needs a positive definite matrix; take lu or gmres")]
    NotPositiveDefinite {
        /// Name of the method.
        method: &'static str,
    },
    /// A quotient of the iteration lost its meaning (0/0, or an underflow).
    #[error("{method} broke down after {iterations} iterations; take a direct method, or scale the system")]
    Breakdown {
        /// Name of the method.
        method: &'static str,
        /// Iterations done.
        iterations: usize,
    },
    /// The caller raised the cancellation flag.
    #[error("cancelled; the method {}", progress(*iterations, *residual))]
    Cancelled {
        /// Iterations done.
        iterations: usize,
        /// Relative residual of the returned x, as last known; infinite if none was computed yet.
        residual: f64,
    },
    /// Infinity or NaN where a number should be, or an entry that an operator did not write.
    #[error("{what} holds infinity, NaN or an entry never written; check how it is computed")]
    NonFinite {
        /// Where it was met.
        what: &'static str,
    },
    /// A slice does not have the length that the partition asks for.
    #[error("{what} has {found} entries, the partition asks for {expected}")]
    DimensionMismatch {
        /// Which slice.
        what: &'static str,
        /// Length needed.
        expected: usize,
        /// Length given.
        found: usize,
    },
    /// A setting is outside its range.
    #[error("setting {name} must be {wanted}")]
    Setting {
        /// Its name.
        name: &'static str,
        /// Its range.
        wanted: &'static str,
    },
}

/// The progress of a method until it ended.
fn progress(iterations: usize, residual: f64) -> String {
    if residual.is_infinite() {
        return "has no solution yet".to_owned();
    }
    format!("left a relative residual of {residual:.2e} after {iterations} iterations")
}
