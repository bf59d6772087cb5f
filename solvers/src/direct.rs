//! The entries that direct methods factor, and how each of them does it.

use crate::error::SolveError;
use crate::factors::Factors;
use crate::halt::Halt;
use crate::operator::Operator;
use crate::panel::Threads;

/// Factorisation of a direct method; all else is the same for all of them.
pub(crate) trait Direct: Sync {
    /// Name in the list of methods.
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
/// Errors of [`entries`].
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
