//! The contract of all solvers.

use std::time::Instant;

use crate::error::SolveError;
use crate::operator::Operator;
use crate::settings::Settings;

/// The state of a solver, passed to the observer after each iteration.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Step<'a> {
    /// Iterations done: sweeps, products, shots, or refinements.
    pub iteration: usize,
    /// ‖r‖₂ / ‖b‖₂ as the method estimates it; recomputed only at the end.
    pub residual: f64,
    /// Matrix entries multiplied so far, divided by dim²: one for a product with the whole matrix.
    pub work: f64,
    /// southwell: b − A x, what is still to be shot.
    pub unshot: Option<&'a [f64]>,
    /// The unknowns at this point; for gmres, at its last restart.
    pub x: &'a [f64],
}

/// The result of a successful solve.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Report {
    /// The method that found x: the choice of `auto`, or the one that another fell back to.
    pub method: &'static str,
    /// Iterations done, counted as in [`Step::iteration`].
    pub iterations: usize,
    /// ‖b − A x‖₂ / ‖b‖₂ of the returned x, recomputed from A, b and x alone.
    pub residual: f64,
    /// The residual before the first iteration, then after each, as in [`Step::residual`].
    pub history: Vec<f64>,
    /// Matrix entries multiplied, divided by dim².
    pub work: f64,
    /// Different block columns that were used.
    pub columns: usize,
    /// Estimate of the condition number ‖A‖₁ ‖A⁻¹‖₁, from below, by a direct method that was asked for it.
    pub condition: Option<f64>,
}

impl<'a> Step<'a> {
    /// The state `x` after so many iterations, at this relative residual; the rest is 0 or absent.
    pub fn new(iteration: usize, residual: f64, x: &'a [f64]) -> Self {
        Self { iteration, residual, work: 0.0, unshot: None, x }
    }
}

impl Report {
    /// The report of `method`, for a solver of one's own, from the residuals before the first iteration and
    /// after each; the residual is the last of them, the rest 0 or absent.
    pub fn new(method: &'static str, history: Vec<f64>) -> Self {
        let (iterations, residual) =
            (history.len().saturating_sub(1), history.last().copied().unwrap_or(0.0));
        Self { method, iterations, residual, history, work: 0.0, columns: 0, condition: None }
    }
}

/// A method that solves A x = b.
pub trait Solver: Sync {
    /// Solves A x = b for one right-hand side.
    ///
    /// `b` and `x` have `a.partition().dim()` entries. Iterations start from the given `x`, direct methods
    /// ignore it. Ok means that the recomputed residual is at most `settings.tolerance`; after an error `x`
    /// holds the best iterate there was, or stays as it was.
    ///
    /// # Errors
    /// See [`SolveError`]; which of them can occur depends on the method.
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError>;

    /// Solves A X = B for several right-hand sides, one after the other in `b` (column `c` at `b[c·dim..]`),
    /// factoring only once where that applies. All columns are tried, unless the caller cancels.
    ///
    /// # Errors
    /// The error of the first column that failed.
    fn solve_many(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Vec<Report>, SolveError> {
        let started = Instant::now();
        column_by_column(a, b, x, |b, x| self.solve(a, b, x, &settings.since(started), observer))
    }
}

/// Runs `solve` on each column of `b` and `x` and keeps the first error.
pub(crate) fn column_by_column(
    a: &dyn Operator,
    b: &[f64],
    x: &mut [f64],
    mut solve: impl FnMut(&[f64], &mut [f64]) -> Result<Report, SolveError>,
) -> Result<Vec<Report>, SolveError> {
    let dim = a.partition().dim();
    check_columns(dim, b, x)?;
    let mut reports = Vec::new();
    let mut failed = None;
    for (b, x) in b.chunks_exact(dim.max(1)).zip(x.chunks_exact_mut(dim.max(1))) {
        match solve(b, x) {
            Ok(report) => reports.push(report),
            Err(cancelled @ SolveError::Cancelled { .. }) => return Err(cancelled),
            Err(error) => failed = failed.or(Some(error)),
        }
    }
    failed.map_or(Ok(reports), Err)
}

/// Refuses `b` and `x` unless both hold the same whole number of columns of `dim` entries.
pub(crate) fn check_columns(dim: usize, b: &[f64], x: &[f64]) -> Result<(), SolveError> {
    let expected = b.len().next_multiple_of(dim.max(1)) * usize::from(dim > 0);
    let mismatch = |what, found| SolveError::DimensionMismatch { what, expected, found };
    if b.len() != expected {
        return Err(mismatch("the right-hand sides", b.len()));
    }
    if x.len() != expected {
        return Err(mismatch("the unknowns", x.len()));
    }
    Ok(())
}
