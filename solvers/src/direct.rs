//! Direct methods: factor once, solve, then check and refine.
//!
//! After each solve the residual is recomputed through the operator, not through the factors, and
//!
//!   r = b − A x,   x ← x + A⁻¹ r
//!
//! is repeated while r is above the aim and falls at least by half (iterative refinement: N. J. Higham,
//! *Accuracy and Stability of Numerical Algorithms*, 2nd ed., SIAM 2002, ch. 12; with a backward stable
//! factorisation it converges while ε κ(A) < 1).

use std::sync::atomic::Ordering;
use std::time::Instant;

use crate::condition::inverse_norm;
use crate::error::{SolveError, Stop};
use crate::factors::Factors;
use crate::operator::Operator;
use crate::problem::{Problem, exploded, finite};
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step, check_columns, column_by_column};
use crate::vector::{add_scaled, all_finite};

/// Refinement goes on until the residual is below this, even if the tolerance is looser. Chosen; not tuned.
const AIM: f64 = 1e-10;

/// Most refinement steps. Chosen; not tuned.
const REFINEMENTS: usize = 10;

/// How a direct method factors; all else is the same for all.
pub(crate) trait Direct: Sync {
    /// Its name in the list of methods.
    const NAME: &'static str;

    /// Entries multiplied by the factorisation, divided by dim³.
    const COST: f64;

    /// Whether `factor` reads the lower triangle only.
    const LOWER: bool = false;

    /// Factors a matrix of dimension `dim` held column by column.
    fn factor(matrix: Vec<f64>, dim: usize, settings: &Settings<'_>) -> Result<Box<dyn Factors>, SolveError>;
}

impl<D: Direct> Solver for D {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let problem = Problem::new(a, b, x, settings)?;
        Factored::new::<D>(a, settings, observer)?.solve(&problem, x)
    }

    fn solve_many(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Vec<Report>, SolveError> {
        check_columns(a.partition().dim(), b, x)?;
        settings.check(a.partition().dim())?;
        let mut factored = Factored::new::<D>(a, settings, observer)?;
        column_by_column(a, b, x, |b, x| {
            let problem = Problem::new(a, b, x, settings)?;
            factored.solve(&problem, x)
        })
    }
}

/// Whether the caller has raised the flag.
fn cancelled(settings: &Settings<'_>) -> bool {
    settings.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed))
}

/// All entries of `a`, column by column.
fn matrix(a: &dyn Operator) -> Vec<f64> {
    if let Some(held) = a.dense() {
        return held.to_vec();
    }
    let partition = a.partition();
    let dim = partition.dim();
    let mut values = vec![0.0; dim * dim];
    for block in 0..partition.len() {
        let range = partition.range(block);
        a.entries(block, &mut values[range.start * dim..range.end * dim]);
    }
    values
}

/// The entries of `a` on and below the diagonal, column by column; those above are anything.
fn lower_triangle(a: &dyn Operator) -> Vec<f64> {
    let Some(held) = a.dense() else { return matrix(a) };
    let dim = a.partition().dim();
    // Pages of zeros cost nothing until they are written.
    let mut values = vec![0.0; dim * dim];
    for j in 0..dim {
        let below = j * dim + j..(j + 1) * dim;
        values[below.clone()].copy_from_slice(&held[below]);
    }
    values
}

/// `error`, or [`SolveError::NonFinite`] if the matrix is not finite: checked only after a failure, since a small
/// residual proves that it is.
fn blame(a: &dyn Operator, error: SolveError) -> SolveError {
    finite(&matrix(a)).err().unwrap_or(error)
}

/// Estimate of ‖A‖₁ ‖A⁻¹‖₁ from below.
fn condition(a: &dyn Operator, factors: &dyn Factors) -> f64 {
    let dim = a.partition().dim();
    let size = |column: &[f64]| column.iter().map(|entry| entry.abs()).sum::<f64>();
    let one_norm = matrix(a).chunks_exact(dim.max(1)).map(size).fold(0.0, f64::max);
    one_norm * inverse_norm(factors, dim)
}

/// A factored matrix that solves, recomputes the residual and refines.
struct Factored<'f> {
    method: &'static str,
    /// Work of the factorisation.
    cost: f64,
    a: &'f dyn Operator,
    factors: Box<dyn Factors>,
    settings: &'f Settings<'f>,
    observer: &'f mut dyn FnMut(&Step<'_>),
    started: Instant,
    condition: Option<f64>,
}

impl<'f> Factored<'f> {
    /// Reads and factors the matrix.
    fn new<D: Direct>(
        a: &'f dyn Operator,
        settings: &'f Settings<'f>,
        observer: &'f mut dyn FnMut(&Step<'_>),
    ) -> Result<Self, SolveError> {
        let dim = a.partition().dim();
        let started = Instant::now();
        let unless_cancelled = || match cancelled(settings) {
            true => Err(SolveError::Cancelled { iterations: 0, residual: f64::INFINITY }),
            false => Ok(()),
        };
        unless_cancelled()?;
        if let Some(held) = a.dense().filter(|held| held.len() != dim * dim) {
            let (expected, found) = (dim * dim, held.len());
            return Err(SolveError::DimensionMismatch { what: "the matrix", expected, found });
        }
        let matrix = if D::LOWER { lower_triangle(a) } else { matrix(a) };
        let factors = D::factor(matrix, dim, settings);
        // Factors that were cancelled are of no meaning, and no error of the matrix.
        unless_cancelled()?;
        let factors = factors.map_err(|error| blame(a, error))?;
        let condition = settings.condition.then(|| condition(a, &*factors));
        let cost = D::COST * dim as f64;
        Ok(Self { method: D::NAME, cost, a, factors, settings, observer, started, condition })
    }

    /// Solves and refines; `x` then holds the result, unless that is not finite.
    fn solve(&mut self, problem: &Problem<'_>, x: &mut [f64]) -> Result<Report, SolveError> {
        if problem.norm == 0.0 {
            x.fill(0.0);
            return Ok(self.report(vec![0.0]));
        }
        let mut first = problem.b.to_vec();
        self.factors.solve(&mut first);
        let singular = || SolveError::Singular { what: "the matrix".into() };
        if !all_finite(&first) {
            return Err(blame(self.a, singular()));
        }
        let mut r = vec![0.0; x.len()];
        let residual = problem.residual(&first, &mut r);
        let residual = residual.map_err(|error| if exploded(&first) { singular() } else { error })?;
        x.copy_from_slice(&first);
        let mut history = vec![residual];
        self.observe(&history, x);
        let ended = self.refine(problem, x, &mut r, &mut history)?;
        let residual = history[history.len() - 1];
        if residual <= self.settings.tolerance {
            return Ok(self.report(history));
        }
        if ended == Stop::Stagnation && condition(self.a, &*self.factors) * f64::EPSILON >= 1.0 {
            return Err(singular());
        }
        Err(SolveError::NotConverged {
            method: self.method,
            iterations: history.len() - 1,
            residual,
            tolerance: self.settings.tolerance,
            stop: ended,
        })
    }

    /// Refines `x`, whose residual is `r`, as long as it pays.
    fn refine(
        &mut self,
        problem: &Problem<'_>,
        x: &mut [f64],
        r: &mut [f64],
        history: &mut Vec<f64>,
    ) -> Result<Stop, SolveError> {
        let mut next = x.to_vec();
        while history.len() <= REFINEMENTS {
            let residual = history[history.len() - 1];
            if residual <= self.settings.tolerance.min(AIM) {
                break;
            }
            if cancelled(self.settings) {
                return Err(SolveError::Cancelled { iterations: history.len() - 1, residual });
            }
            if self.settings.time_budget.is_some_and(|budget| self.started.elapsed() >= budget) {
                return Ok(Stop::Time);
            }
            self.factors.solve(r);
            next.copy_from_slice(x);
            add_scaled(1.0, r, &mut next);
            let refined = match problem.residual(&next, r) {
                Ok(refined) if refined < residual => refined,
                // A correction that does not help: x stays as it was.
                _ => break,
            };
            x.copy_from_slice(&next);
            history.push(refined);
            self.observe(history, x);
            if refined > 0.5 * residual {
                break;
            }
        }
        Ok(Stop::Stagnation)
    }

    /// Matrix entries multiplied, over dim²: the factorisation, then two triangles and one product per step.
    fn work(&self, steps: usize) -> f64 {
        self.cost + 2.0 * steps as f64
    }

    fn observe(&mut self, history: &[f64], x: &[f64]) {
        let (iteration, residual) = (history.len() - 1, history[history.len() - 1]);
        let work = self.work(history.len());
        (self.observer)(&Step { iteration, residual, work, largest_unshot: None, ambient: None, x });
    }

    /// The account of a success.
    fn report(&self, history: Vec<f64>) -> Report {
        Report {
            method: self.method,
            iterations: history.len() - 1,
            residual: history[history.len() - 1],
            work: self.work(history.len()),
            columns: self.a.partition().len(),
            condition: self.condition,
            history,
        }
    }
}
