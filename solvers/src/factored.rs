//! A matrix factored once, which solves for one right-hand side after the other, checks and refines.
//!
//! After each solve the residual is recomputed through the operator, not through the factors, and
//!
//!   r = b − A x,   x ← x + A⁻¹ r
//!
//! is repeated while r is above the aim and falls at least by half (iterative refinement: N. J. Higham,
//! *Accuracy and Stability of Numerical Algorithms*, 2nd ed., SIAM 2002, ch. 12; with a backward stable
//! factorisation it converges while ε κ(A) < 1).

use std::fmt;
use std::time::Instant;

use rayon::prelude::*;

use crate::bundle::COLUMNS;
use crate::condition::inverse_norm;
use crate::direct::{Direct, entries, lower_triangle};
use crate::error::{SolveError, Stop};
use crate::factors::Factors;
use crate::halt::Halt;
use crate::operator::Operator;
use crate::panel::Threads;
use crate::problem::{Problem, exploded, finite};
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step, check_columns, column_by_column};
use crate::tolerances::REFINED;
use crate::vector::{add_scaled, all_finite};

/// Most refinement steps, each of which has to halve the residual: ten of them divide it by 1000 at least.
const REFINEMENTS: usize = 10;

/// A matrix with its factors, made by [`Lu::factor`](crate::lu::Lu::factor) or
/// [`Cholesky::factor`](crate::cholesky::Cholesky::factor).
///
/// ```
/// use nalgebra::DMatrix;
/// use radiosity_solvers::{Dense, Settings, lu::Lu};
///
/// let a = Dense::try_from(DMatrix::from_row_slice(2, 2, &[4.0, 1.0, 2.0, 3.0]))?;
/// let factored = Lu.factor(&a, &Settings::default())?;
/// for b in [[5.0, 5.0], [3.0, -1.0]] {
///     let mut x = [0.0; 2];
///     let report = factored.solve(&b, &mut x)?;
///     assert!(report.residual <= 1e-15);
/// }
/// # Ok::<(), radiosity_solvers::SolveError>(())
/// ```
pub struct Factored<'a> {
    method: &'static str,
    /// Entries multiplied by the factorisation, divided by dim².
    cost: f64,
    a: &'a dyn Operator,
    factors: Box<dyn Factors>,
    settings: Settings<'a>,
    condition: Option<f64>,
}

impl fmt::Debug for Factored<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { method, condition, .. } = self;
        f.debug_struct("Factored")
            .field("method", method)
            .field("condition", condition)
            .finish_non_exhaustive()
    }
}

impl<'a> Factored<'a> {
    /// Reads and factors the matrix.
    ///
    /// # Errors
    /// Errors of [`Lu::factor`](crate::lu::Lu::factor) and [`SolveError::NotPositiveDefinite`].
    pub(crate) fn new<D: Direct>(a: &'a dyn Operator, settings: &Settings<'a>) -> Result<Self, SolveError> {
        let dim = a.partition().dim();
        settings.check(dim)?;
        let halt = Halt::new(D::NAME, settings, Instant::now());
        halt.check_factoring()?;
        if let Some(held) = a.dense().filter(|held| held.len() != dim * dim) {
            let (expected, found) = (dim * dim, held.len());
            return Err(SolveError::DimensionMismatch { what: "the matrix", expected, found });
        }
        let between = || halt.check_factoring();
        let matrix = if D::LOWER { lower_triangle(a, &between) } else { entries(a, &between) }?;
        let factors = D::factor(matrix, dim, Threads::new(dim, settings.threads), &halt);
        let factors =
            factors.map_err(|error| if is_of_the_matrix(&error) { blame(a, error) } else { error })?;
        let condition = settings.condition.then(|| condition(a, &*factors));
        let cost = D::COST * dim as f64;
        Ok(Self { method: D::NAME, cost, a, factors, settings: settings.clone(), condition })
    }

    /// Solves A x = b: Ok means that ‖b − A x‖₂ / ‖b‖₂, recomputed, is at most the tolerance of the settings
    /// with which the matrix was factored. `b` and `x` have `dim` entries; the first value of `x` is ignored.
    /// The time budget begins anew.
    ///
    /// # Errors
    /// [`SolveError::DimensionMismatch`], [`SolveError::NonFinite`], [`SolveError::Singular`],
    /// [`SolveError::NotConverged`], [`SolveError::Cancelled`]; `x` then holds the best iterate there was, or
    /// is as it was.
    pub fn solve(&self, b: &[f64], x: &mut [f64]) -> Result<Report, SolveError> {
        let problem = Problem::new(self.a, b, x, &self.settings)?;
        let first = Guess::by(self, b);
        self.refine_from(first.column(0, b.len()), &problem, x, Instant::now(), &mut |_| ())
    }

    /// Solves and refines from a guess, within a time budget that began at `started`.
    fn refine_from(
        &self,
        guess: ColumnGuess<'_>,
        problem: &Problem<'_>,
        x: &mut [f64],
        started: Instant,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let halt = Halt::new(self.method, &self.settings, started);
        halt.check_factoring()?;
        if problem.norm == 0.0 {
            x.fill(0.0);
            return Ok(self.report(vec![0.0]));
        }
        let mut refinement = Refinement::new(self, guess, problem, x, observer)?;
        let ended = refinement.run(&halt);
        let (residual, tolerance) = (refinement.residual(), self.settings.tolerance);
        if residual <= tolerance && !matches!(ended, Err(SolveError::Cancelled { .. })) {
            return Ok(self.report(refinement.history));
        }
        ended?;
        if condition(self.a, &*self.factors) * f64::EPSILON >= 1.0 {
            return Err(singular());
        }
        let (method, iterations) = (self.method, refinement.history.len() - 1);
        Err(SolveError::NotConverged { method, iterations, residual, tolerance, stop: Stop::Stagnation })
    }

    /// Matrix entries multiplied, over dim²: the factorisation, then two triangles and one product per step.
    fn work(&self, steps: usize) -> f64 {
        self.cost + 2.0 * steps as f64
    }

    /// The report of a success.
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
        let started = Instant::now();
        let factored = Factored::new::<D>(a, settings)?;
        let guess = Guess::by(&factored, b);
        factored.refine_from(guess.column(0, b.len()), &problem, x, started, observer)
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
        let started = Instant::now();
        let factored = Factored::new::<D>(a, settings)?;
        let dim = a.partition().dim();
        let at_once = COLUMNS * if settings.threads == 1 { 1 } else { rayon::current_num_threads() };
        let (mut column, mut guess) = (0, Guess::by(&factored, &[]));
        column_by_column(a, b, x, |own, x| {
            if column % at_once == 0 {
                guess = Guess::by(&factored, &b[column * dim..b.len().min((column + at_once) * dim)]);
            }
            let first = guess.column(column % at_once, dim);
            column += 1;
            let problem = Problem::new(a, own, x, settings)?;
            factored.refine_from(first, &problem, x, started, observer)
        })
    }
}

/// Solutions by the factors alone, of several right-hand sides.
struct Guess {
    /// A⁻¹ b, column after column.
    x: Vec<f64>,
    /// A x.
    product: Vec<f64>,
}

/// One column of a guess.
#[derive(Clone, Copy)]
struct ColumnGuess<'g> {
    x: &'g [f64],
    product: &'g [f64],
}

impl Guess {
    /// The solutions for the columns of `b`.
    fn by(factored: &Factored<'_>, b: &[f64]) -> Self {
        let (mut x, mut product) = (b.to_vec(), vec![f64::NAN; b.len()]);
        let columns = COLUMNS * factored.a.partition().dim().max(1);
        let solve = |x: &mut [f64], product: &mut [f64]| {
            factored.factors.solve(x);
            factored.a.apply_many(x, product);
        };
        if b.len() <= columns {
            solve(&mut x, &mut product);
        } else {
            let bundles = x.par_chunks_mut(columns).zip(product.par_chunks_mut(columns));
            bundles.for_each(|(x, product)| solve(x, product));
        }
        Self { x, product }
    }

    fn column(&self, column: usize, dim: usize) -> ColumnGuess<'_> {
        let range = column * dim..(column + 1) * dim;
        ColumnGuess { x: &self.x[range.clone()], product: &self.product[range] }
    }
}

/// A solution on its way: x, its residual, and the residuals before.
struct Refinement<'r, 'f> {
    factored: &'r Factored<'f>,
    problem: &'r Problem<'r>,
    x: &'r mut [f64],
    /// b − A x.
    r: Vec<f64>,
    /// ‖b − A x‖₂ / ‖b‖₂ of the first x and after each refinement.
    history: Vec<f64>,
    observer: &'r mut dyn FnMut(&Step<'_>),
}

impl<'r, 'f> Refinement<'r, 'f> {
    /// x by the guess; keeps `x` where that is not finite.
    fn new(
        factored: &'r Factored<'f>,
        ColumnGuess { x: first, product }: ColumnGuess<'_>,
        problem: &'r Problem<'r>,
        x: &'r mut [f64],
        observer: &'r mut dyn FnMut(&Step<'_>),
    ) -> Result<Self, SolveError> {
        if !all_finite(first) {
            return Err(blame(factored.a, singular()));
        }
        finite(product).map_err(|error| if exploded(first) { singular() } else { error })?;
        let mut r = product.to_vec();
        let residual = problem.residual_of(&mut r);
        x.copy_from_slice(first);
        let mut own = Self { factored, problem, x, r, history: vec![residual], observer };
        own.observe();
        Ok(own)
    }

    /// ‖b − A x‖₂ / ‖b‖₂.
    fn residual(&self) -> f64 {
        self.history[self.history.len() - 1]
    }

    /// Refines x as long as it pays.
    fn run(&mut self, halt: &Halt<'_>) -> Result<(), SolveError> {
        let aim = self.factored.settings.tolerance.min(REFINED);
        while self.history.len() <= REFINEMENTS && self.residual() > aim {
            let residual = self.residual();
            halt.check(self.history.len() - 1, residual)?;
            if !self.improve() || self.residual() > 0.5 * residual {
                break;
            }
        }
        Ok(())
    }

    /// x ← x + A⁻¹ r, unless the residual does not fall; returns whether it fell.
    fn improve(&mut self) -> bool {
        self.factored.factors.solve(&mut self.r);
        let mut next = self.x.to_vec();
        add_scaled(1.0, &self.r, &mut next);
        match self.problem.residual(&next, &mut self.r) {
            Ok(refined) if refined < self.residual() => self.history.push(refined),
            _ => return false,
        }
        self.x.copy_from_slice(&next);
        self.observe();
        true
    }

    fn observe(&mut self) {
        let (iteration, residual) = (self.history.len() - 1, self.residual());
        let work = self.factored.work(self.history.len());
        let step = Step { iteration, residual, work, unshot: None, x: self.x };
        (self.observer)(&step);
    }
}

fn singular() -> SolveError {
    SolveError::Singular { what: "the matrix".into() }
}

/// Whether the entries of the matrix, and not the caller, ended the factorisation.
fn is_of_the_matrix(error: &SolveError) -> bool {
    matches!(error, SolveError::Singular { .. } | SolveError::NotPositiveDefinite { .. })
}

/// `error`, or [`SolveError::NonFinite`] if the matrix is not finite: checked only after a failure, since a
/// small residual proves that it is.
fn blame(a: &dyn Operator, error: SolveError) -> SolveError {
    finite(&matrix(a)).err().unwrap_or(error)
}

/// All entries, however long they take to be read.
fn matrix(a: &dyn Operator) -> Vec<f64> {
    entries(a, &|| Ok(())).unwrap_or_default()
}

/// Estimate of ‖A‖₁ ‖A⁻¹‖₁ from below.
fn condition(a: &dyn Operator, factors: &dyn Factors) -> f64 {
    let dim = a.partition().dim();
    let size = |column: &[f64]| column.iter().map(|entry| entry.abs()).sum::<f64>();
    let one_norm = matrix(a).chunks_exact(dim.max(1)).map(size).fold(0.0, f64::max);
    one_norm * inverse_norm(factors, dim)
}

#[cfg(test)]
mod many {
    use crate::Dense;
    use crate::lu::Lu;
    use crate::partition::Partition;
    use crate::solver::Solver;
    use crate::{Settings, cholesky::Cholesky};

    /// (I + u uᵀ / n) x = b has the solution x = b − u ⟨u, b⟩ / (n + ⟨u, u⟩).
    #[test]
    fn more_right_hand_sides_than_pass_at_once_are_all_solved_for() {
        let (dim, columns) = (40, 71);
        let u: Vec<f64> = (0..dim).map(|i| 1.0 + (i % 5) as f64).collect();
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let entry = |k: usize| {
            let (i, j) = (k % dim, k / dim);
            f64::from(u8::from(i == j)) + u[i] * u[j] / dim as f64
        };
        let values = (0..dim * dim).map(entry).collect();
        let a = Dense::new(Partition::new(&[dim]), values, true).expect("a matrix");
        // One of them is 0.
        let b: Vec<f64> = (0..dim * columns).map(|k| (k / dim % 50) as f64 * (k % 13) as f64).collect();
        for solver in [&Cholesky as &dyn Solver, &Lu] {
            let mut x = vec![f64::NAN; b.len()];
            let reports = solver.solve_many(&a, &b, &mut x, &Settings::default(), &mut |_| ());
            assert_eq!(reports.expect("they are solved for").len(), columns);
            for (x, b) in x.chunks_exact(dim).zip(b.chunks_exact(dim)) {
                let part = product(&u, b) / (dim as f64 + product(&u, &u));
                for ((x, b), u) in x.iter().zip(b).zip(&u) {
                    assert!((x - (b - u * part)).abs() <= 1e-11 * 600.0, "{x}");
                }
            }
        }
    }
}
