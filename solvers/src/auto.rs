//! The method that fits the matrix, its size, and what is asked.
//!
//! A direct method while its n³/6 (Cholesky) or n³/3 (LU) multiplications, fast ones in cache, cost less than the
//! products of an iteration, slow ones from memory, for all right-hand sides together; beyond that cg or gmres, and a
//! direct method again where they fail. Symmetric matrices are tried as positive definite first.

use std::time::Instant;

use crate::cg::Cg;
#[cfg(feature = "faer")]
use crate::cholesky::Cholesky;
use crate::error::{SolveError, Stop};
use crate::gmres::Gmres;
#[cfg(feature = "faer")]
use crate::lu::Lu;
#[cfg(not(feature = "faer"))]
use crate::lu_small::LuSmall as Lu;
use crate::operator::Operator;
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step};

/// Name in the list of methods.
pub(crate) const NAME: &str = "auto";

/// Unknowns per right-hand side up to which a direct method comes first.
const DIRECT: usize = if cfg!(feature = "faer") { 2000 } else { 500 };

/// Unknowns from which a direct method is not even tried: the copy of the matrix alone takes 7 GB.
const HUGE: usize = 30_000;

/// Tolerance below which iterations may fail where a refined direct method does not.
const STRICT: f64 = 1e-13;

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
        in_turn(candidates(a, 1, settings), settings, |solver, settings| {
            solver.solve(a, b, x, settings, observer)
        })
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
        in_turn(candidates(a, columns, settings), settings, |solver, settings| {
            solver.solve_many(a, b, x, settings, observer)
        })
    }
}

/// The methods to try, in order; never none.
fn candidates(a: &dyn Operator, columns: usize, settings: &Settings<'_>) -> Vec<&'static dyn Solver> {
    let dim = a.partition().dim();
    let mut direct: Vec<&'static dyn Solver> = vec![&Lu];
    let mut iterative: Vec<&'static dyn Solver> = vec![&Gmres];
    if a.symmetric() {
        #[cfg(feature = "faer")]
        direct.insert(0, &Cholesky);
        iterative.insert(0, &Cg);
    }
    if dim >= HUGE {
        return iterative;
    }
    if dim <= DIRECT.saturating_mul(columns.max(1)) || settings.tolerance < STRICT {
        return direct;
    }
    iterative.append(&mut direct);
    iterative
}

/// Tries one method after the other, each in the time the earlier ones left, until one succeeds or none can.
fn in_turn<T>(
    candidates: Vec<&'static dyn Solver>,
    settings: &Settings<'_>,
    mut attempt: impl FnMut(&dyn Solver, &Settings<'_>) -> Result<T, SolveError>,
) -> Result<T, SolveError> {
    let started = Instant::now();
    let mut outcome = None;
    for solver in candidates {
        let time_budget = settings.time_budget.map(|budget| budget.saturating_sub(started.elapsed()));
        let tried = attempt(solver, &Settings { time_budget, ..settings.clone() });
        let hopeless = tried.as_ref().err().is_none_or(is_final);
        outcome = Some(tried);
        if hopeless {
            break;
        }
    }
    outcome.unwrap_or(Err(SolveError::Breakdown { method: NAME, iterations: 0 }))
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
