//! Cholesky factorisation.
//!
//! A = L Lᵀ in n³/6 multiplications from the lower triangle of A alone, half of what LU takes. The residual
//! is recomputed with all of A and refined; where that does not reach the tolerance (a matrix that is not as
//! symmetric as it claims, or factors gone wrong) LU takes over. Exists exactly for symmetric positive
//! definite A. Reference: N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., SIAM 2002,
//! ch. 10.

use std::time::Instant;

use crate::cholesky_factor::CholeskyFactor;
use crate::direct::Direct;
use crate::error::{SolveError, Stop};
use crate::factors::Factors;
use crate::lu::Lu;
use crate::operator::Operator;
use crate::panel::Labour;
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step};

pub(crate) const NAME: &str = "cholesky";

/// Cholesky with refinement, LU where that fails; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Cholesky;

impl Solver for Cholesky {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        require_symmetric(a)?;
        let started = Instant::now();
        match LowerTriangle.solve(a, b, x, settings, observer) {
            Err(error) if calls_for_lu(&error) => Lu.solve(a, b, x, &settings.since(started), observer),
            outcome => outcome,
        }
    }

    fn solve_many(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Vec<Report>, SolveError> {
        require_symmetric(a)?;
        let started = Instant::now();
        match LowerTriangle.solve_many(a, b, x, settings, observer) {
            Err(error) if calls_for_lu(&error) => Lu.solve_many(a, b, x, &settings.since(started), observer),
            outcome => outcome,
        }
    }
}

/// Refuses an operator that does not claim to be symmetric.
fn require_symmetric(a: &dyn Operator) -> Result<(), SolveError> {
    if a.symmetric() { Ok(()) } else { Err(SolveError::NotSymmetric { method: NAME }) }
}

/// Whether the factors are to be distrusted, and there is time to do something about it.
fn calls_for_lu(error: &SolveError) -> bool {
    match error {
        SolveError::NotConverged { stop, .. } => *stop != Stop::Time,
        SolveError::Singular { .. } => true,
        _ => false,
    }
}

/// The factorisation alone, without the fall-back.
struct LowerTriangle;

impl Direct for LowerTriangle {
    const NAME: &'static str = NAME;

    const COST: f64 = 1.0 / 6.0;

    const LOWER: bool = true;

    fn factor(matrix: Vec<f64>, dim: usize, settings: &Settings<'_>) -> Result<Box<dyn Factors>, SolveError> {
        let factor = CholeskyFactor::new(matrix, dim, Labour::of(settings));
        Ok(Box::new(factor.ok_or(SolveError::NotPositiveDefinite { method: NAME })?))
    }
}
