//! Chooses the method by the matrix, its size and the tolerance.
//!
//! A small system goes to Cholesky or LU, whose n³/6 or n³/3 multiplications in cache then cost less than a
//! few products with a matrix from memory. A larger one goes to cg or gmres, which need 10 products where a
//! factorisation takes the time of 30 or more; where they have not finished in about that time, a direct
//! method takes over. A tolerance near the rounding floor asks for a direct method wherever one is
//! affordable; the largest systems are always iterated. Symmetric matrices are tried as positive definite
//! first. Where cg finds that one is not, as one whose blocks few rays found may be, Cholesky is passed over
//! and gmres comes before LU if the entries are not held: to make them takes a product for each column.

use std::time::Instant;

use crate::cg::Cg;
use crate::cholesky::Cholesky;
use crate::error::{SolveError, Stop};
use crate::gmres::Gmres;
use crate::lu::Lu;
use crate::operator::Operator;
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step};
use crate::tolerances::STRICT;

pub(crate) const NAME: &str = "auto";

/// Unknowns per right-hand side up to which a direct method comes first; in all, if the entries are not held.
/// Factors of so many take 4·10⁷ multiplications, less than a time that shows, and the solution is right to
/// rounding.
pub const DIRECT: usize = 500;

/// Unknowns from which no direct method is tried: the copy of the matrix would take 7 GB.
const HUGE: usize = 30_000;

/// Unknowns up to which the matrix is made entry by entry for a direct method where it is not held so: 72 MB.
pub const DENSE: usize = 3000;

/// Chooses among the other methods; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Auto;

impl Solver for Auto {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        Plan::new(a, 1, settings).run(settings, |solver, settings| solver.solve(a, b, x, settings, observer))
    }

    fn solve_many(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Vec<Report>, SolveError> {
        let columns = b.len() / a.partition().dim().max(1);
        Plan::new(a, columns, settings)
            .run(settings, |solver, settings| solver.solve_many(a, b, x, settings, observer))
    }
}

/// A method that may be tried.
struct Attempt {
    solver: &'static dyn Solver,
    /// Whether it is for positive definite matrices, which one that is symmetric is taken to be until a
    /// method finds that it is not, or for others only; None for all.
    definite: Option<bool>,
}

impl Attempt {
    fn of_definite(solver: &'static dyn Solver) -> Self {
        Self { solver, definite: Some(true) }
    }
}

/// The methods to try, in order.
struct Plan {
    first: Vec<Attempt>,
    last: &'static dyn Solver,
    /// Most iterations before the last method is tried: they cost about as much as a factorisation.
    patience: usize,
}

impl Plan {
    /// The plan for `a` and this many right-hand sides.
    fn new(a: &dyn Operator, columns: usize, settings: &Settings<'_>) -> Self {
        let dim = a.partition().dim();
        // One factorisation serves all columns; the entries of what is not held so would first take a product
        // each.
        let shares = if a.dense().is_some() { columns.max(1) } else { 1 };
        let direct_only = dim <= DIRECT.saturating_mul(shares) || settings.tolerance < STRICT;
        let is_held = a.dense().is_some();
        let [cg, cholesky] = [&Cg as &'static dyn Solver, &Cholesky].map(Attempt::of_definite);
        let gmres = |definite| Attempt { solver: &Gmres, definite };
        if dim >= HUGE || (dim > DENSE && !is_held) {
            let first = if a.symmetric() { vec![cg] } else { Vec::new() };
            return Self { first, last: &Gmres, patience: usize::MAX };
        }
        let first = match (a.symmetric(), direct_only) {
            (true, true) => vec![cholesky],
            (true, false) if is_held => vec![cg, cholesky],
            (true, false) => vec![cg, gmres(Some(false)), cholesky],
            (false, true) => Vec::new(),
            (false, false) => vec![gmres(None)],
        };
        Self { first, last: &Lu, patience: 50 + dim / 40 }
    }

    /// Tries one method after the other, each in the time that the earlier ones left.
    fn run<T>(
        self,
        settings: &Settings<'_>,
        mut attempt: impl FnMut(&dyn Solver, &Settings<'_>) -> Result<T, SolveError>,
    ) -> Result<T, SolveError> {
        let started = Instant::now();
        let mut tried =
            |solver, max_iterations| attempt(solver, &Settings { max_iterations, ..settings.since(started) });
        let mut is_definite = true;
        for Attempt { solver, definite } in self.first {
            if definite.is_some_and(|definite| definite != is_definite) {
                continue;
            }
            match tried(solver, settings.max_iterations.min(self.patience)) {
                Err(SolveError::NotPositiveDefinite { .. }) => is_definite = false,
                Err(error) if !is_final(&error) => {}
                outcome => return outcome,
            }
        }
        tried(self.last, settings.max_iterations)
    }
}

/// Whether no other method could do better after this error.
fn is_final(error: &SolveError) -> bool {
    match error {
        SolveError::NotConverged { stop, .. } => *stop == Stop::Time,
        SolveError::Cancelled { .. }
        | SolveError::NonFinite { .. }
        | SolveError::DimensionMismatch { .. }
        | SolveError::Setting { .. } => true,
        _ => false,
    }
}
