//! Direct methods: read the matrix, factor it, solve.

use std::time::Instant;

use crate::error::SolveError;
use crate::factored::Factored;
use crate::factors::Factors;
use crate::halt::Halt;
use crate::operator::Operator;
use crate::panel::Threads;
use crate::problem::Problem;
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step, check_columns, column_by_column};

/// How a direct method factors; all else is the same for all.
pub(crate) trait Direct: Sync {
    /// Its name in the list of methods.
    const NAME: &'static str;

    /// Entries multiplied by the factorisation, divided by dim³.
    const COST: f64;

    /// Whether `factor` reads the lower triangle only.
    const LOWER: bool = false;

    /// Factors a matrix of dimension `dim` held column by column.
    fn factor(
        matrix: Vec<f64>,
        dim: usize,
        threads: Threads,
        halt: &Halt<'_>,
    ) -> Result<Box<dyn Factors>, SolveError>;
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
        Factored::new::<D>(a, settings)?.refine_from(&problem, x, started, observer)
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
        column_by_column(a, b, x, |b, x| {
            let problem = Problem::new(a, b, x, settings)?;
            factored.refine_from(&problem, x, started, observer)
        })
    }
}

/// All entries of `a`, column by column; `between` is asked before each block.
///
/// # Errors
/// The first of `between`.
pub(crate) fn entries(
    a: &dyn Operator,
    between: &dyn Fn() -> Result<(), SolveError>,
) -> Result<Vec<f64>, SolveError> {
    if let Some(held) = a.dense() {
        return Ok(held.to_vec());
    }
    let partition = a.partition();
    let dim = partition.dim();
    let mut values = vec![0.0; dim * dim];
    for block in 0..partition.len() {
        between()?;
        let range = partition.range(block);
        a.entries(block, &mut values[range.start * dim..range.end * dim]);
    }
    Ok(values)
}

/// The entries of `a` on and below the diagonal, column by column; those above are anything.
///
/// # Errors
/// Those of [`entries`].
pub(crate) fn lower_triangle(
    a: &dyn Operator,
    between: &dyn Fn() -> Result<(), SolveError>,
) -> Result<Vec<f64>, SolveError> {
    let Some(held) = a.dense() else { return entries(a, between) };
    let dim = a.partition().dim();
    // Pages of zeros cost nothing until they are written.
    let mut values = vec![0.0; dim * dim];
    for j in 0..dim {
        let below = j * dim + j..(j + 1) * dim;
        values[below.clone()].copy_from_slice(&held[below]);
    }
    Ok(values)
}
