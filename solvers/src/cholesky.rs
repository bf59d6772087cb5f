//! Cholesky factorisation, blocked and threaded.
//!
//! A = L Lᵀ in n³/6 multiplications from the lower triangle of A alone, half of what LU takes. The residual
//! is recomputed with all of A and refined; where that does not reach the tolerance (a matrix that is not as
//! symmetric as it claims, or factors gone wrong) LU takes over. Exists exactly for symmetric positive
//! definite A. Reference: N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., SIAM 2002,
//! ch. 10.

use std::time::Instant;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::{factor, solve};
use faer::{MatMut, MatRef, Par};

use crate::direct::Direct;
use crate::error::{SolveError, Stop};
use crate::factors::Factors;
use crate::lu::{Lu, parallelism};
use crate::operator::Operator;
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

    /// A = L Lᵀ, in place.
    fn factor(
        mut matrix: Vec<f64>,
        dim: usize,
        settings: &Settings<'_>,
    ) -> Result<Box<dyn Factors>, SolveError> {
        let par = parallelism(dim, settings.threads);
        let scratch = factor::cholesky_in_place_scratch::<f64>(dim, par, Default::default());
        factor::cholesky_in_place(
            MatMut::from_column_major_slice_mut(&mut matrix, dim, dim),
            Default::default(),
            par,
            MemStack::new(&mut MemBuffer::new(scratch)),
            Default::default(),
        )
        .map_err(|_| SolveError::NotPositiveDefinite { method: NAME })?;
        Ok(Box::new(Triangle { matrix, dim }))
    }
}

/// L on and below the diagonal.
struct Triangle {
    matrix: Vec<f64>,
    dim: usize,
}

impl Factors for Triangle {
    fn solve(&self, x: &mut [f64]) {
        let scratch = solve::solve_in_place_scratch::<f64>(self.dim, 1, Par::Seq);
        solve::solve_in_place(
            MatRef::from_column_major_slice(&self.matrix, self.dim, self.dim),
            MatMut::from_column_major_slice_mut(x, self.dim, 1),
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
        );
    }

    fn solve_transposed(&self, x: &mut [f64]) {
        self.solve(x);
    }
}
