//! LU factorisation with partial pivoting, by faer.
//!
//! P A = L U in n³/3 multiplications, then two triangles per right-hand side; the residual of the solution is
//! recomputed and refined. Backward stable in practice for every nonsingular matrix. The columns are taken in
//! panels [A₁ A₂], of which the first is factored and the rest updated,
//!
//!   P₁ A₁ = [L₁₁; L₂₁] U₁₁,   U₁₂ = L₁₁⁻¹ (P₁ A₂)₁,   A₂₂ ← (P₁ A₂)₂ − L₂₁ U₁₂.
//!
//! Reference: G. Golub, C. Van Loan, *Matrix Computations*, 4th ed., Johns Hopkins 2013, §3.4.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::{factor, solve};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_unit_lower_triangular_in_place;
use faer::perm::PermRef;
use faer::{Accum, MatMut, MatRef, Par};
use rayon::prelude::*;

use crate::direct::Direct;
use crate::error::SolveError;
use crate::factored::Factored;
use crate::factors::Factors;
use crate::halt::Halt;
use crate::operator::Operator;
use crate::panel::{PANEL, Threads};
use crate::settings::Settings;

pub(crate) const NAME: &str = "lu";

/// LU with partial pivoting and refinement; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Lu;

impl Lu {
    /// Factors `a` once, to solve with it often.
    ///
    /// # Errors
    /// [`SolveError::Singular`] if a pivot is 0 or its inverse overflows, [`SolveError::NonFinite`],
    /// [`SolveError::DimensionMismatch`] if the operator holds another number of entries than dim²,
    /// [`SolveError::Setting`], [`SolveError::Cancelled`], and [`SolveError::NotConverged`] once the time
    /// budget is used up.
    pub fn factor<'a>(
        &self,
        a: &'a dyn Operator,
        settings: &Settings<'a>,
    ) -> Result<Factored<'a>, SolveError> {
        Factored::new::<Self>(a, settings)
    }
}

impl Direct for Lu {
    const NAME: &'static str = NAME;

    const COST: f64 = 1.0 / 3.0;

    fn factor(
        mut matrix: Vec<f64>,
        dim: usize,
        threads: Threads,
        halt: &Halt<'_>,
    ) -> Result<Box<dyn Factors>, SolveError> {
        let rows = eliminate(&mut matrix, dim, threads, halt)?;
        // faer multiplies by the inverses of pivots.
        if (0..dim).any(|k| !matrix[k * dim + k].recip().is_finite()) {
            return Err(SolveError::Singular { what: "the matrix".into() });
        }
        let mut inverse = vec![0; dim];
        rows.iter().enumerate().for_each(|(k, row)| inverse[*row] = k);
        Ok(Box::new(Triangles { matrix, rows, inverse }))
    }
}

/// P A = L U in place, panel by panel; returns the row of A that each row of P A is.
fn eliminate(
    matrix: &mut [f64],
    dim: usize,
    threads: Threads,
    halt: &Halt<'_>,
) -> Result<Vec<usize>, SolveError> {
    let mut rows: Vec<usize> = (0..dim).collect();
    for start in (0..dim).step_by(PANEL) {
        halt.check_factoring()?;
        let width = PANEL.min(dim - start);
        let (left, rest) = matrix.split_at_mut(start * dim);
        let (panel, right) = rest.split_at_mut(width * dim);
        let mut panel = MatMut::from_column_major_slice_mut(panel, dim, width).split_at_row_mut(start).1;
        let moves = Moves::new(factor_panel(panel.as_mut(), threads));
        moves.apply(&mut rows[start..]);
        moves.apply_to_columns(left, dim, start, threads);
        let (diagonal, below) = panel.as_ref().split_at_row(width);
        for columns in right.chunks_mut(PANEL * dim) {
            halt.check_factoring()?;
            moves.apply_to_columns(columns, dim, start, threads);
            let count = columns.len() / dim;
            let par = threads.for_columns(count);
            let columns = MatMut::from_column_major_slice_mut(columns, dim, count).split_at_row_mut(start).1;
            let (mut top, bottom) = columns.split_at_row_mut(width);
            solve_unit_lower_triangular_in_place(diagonal, top.as_mut(), par);
            matmul(bottom, Accum::Add, below, top.as_ref(), -1.0, par);
        }
    }
    Ok(rows)
}

/// P₁ A₁ = [L₁₁; L₂₁] U₁₁ in place; returns the row of A₁ that each row of P₁ A₁ is.
fn factor_panel(panel: MatMut<'_, f64>, threads: Threads) -> Vec<usize> {
    let (rows, columns) = (panel.nrows(), panel.ncols());
    let par = threads.for_columns(columns);
    let (mut forward, mut inverse) = (vec![0; rows], vec![0; rows]);
    let scratch = factor::lu_in_place_scratch::<usize, f64>(rows, columns, par, Default::default());
    let stack = &mut MemBuffer::new(scratch);
    factor::lu_in_place(panel, &mut forward, &mut inverse, par, MemStack::new(stack), Default::default());
    forward
}

/// A permutation by the places that it changes: at most two for each column of a panel.
struct Moves(Vec<Move>);

/// A row that comes from the place `from` to the place `to`.
struct Move {
    from: usize,
    to: usize,
}

impl Moves {
    /// The permutation that brings row `forward[k]` to the place k.
    fn new(forward: Vec<usize>) -> Self {
        let moves = forward.into_iter().enumerate().map(|(to, from)| Move { from, to });
        Self(moves.filter(|own| own.from != own.to).collect())
    }

    fn apply<T: Copy>(&self, entries: &mut [T]) {
        let moved: Vec<T> = self.0.iter().map(|own| entries[own.from]).collect();
        self.0.iter().zip(moved).for_each(|(own, entry)| entries[own.to] = entry);
    }

    /// Permutes the rows from `start` on of whole columns of `dim` entries.
    fn apply_to_columns(&self, columns: &mut [f64], dim: usize, start: usize, threads: Threads) {
        if threads.are_alone() {
            columns.chunks_exact_mut(dim).for_each(|column| self.apply(&mut column[start..]));
        } else {
            columns.par_chunks_exact_mut(dim).for_each(|column| self.apply(&mut column[start..]));
        }
    }
}

/// L below the diagonal, with ones on it, and U above, of a matrix whose rows were permuted.
struct Triangles {
    /// Entry (i, j) at `matrix[j·dim + i]`.
    matrix: Vec<f64>,
    /// Row k of L U is row `rows[k]` of the matrix.
    rows: Vec<usize>,
    /// Row k of the matrix is row `inverse[k]` of L U.
    inverse: Vec<usize>,
}

impl Triangles {
    fn matrix(&self) -> MatRef<'_, f64> {
        MatRef::from_column_major_slice(&self.matrix, self.rows.len(), self.rows.len())
    }

    fn permutation(&self) -> PermRef<'_, usize> {
        PermRef::new_checked(&self.rows, &self.inverse, self.rows.len())
    }
}

impl Factors for Triangles {
    fn solve(&self, x: &mut [f64]) {
        let dim = self.rows.len();
        let scratch = solve::solve_in_place_scratch::<usize, f64>(dim, 1, Par::Seq);
        let (matrix, buffer) = (self.matrix(), &mut MemBuffer::new(scratch));
        for x in x.chunks_exact_mut(dim.max(1)) {
            let x = MatMut::from_column_major_slice_mut(x, dim, 1);
            let stack = MemStack::new(buffer);
            solve::solve_in_place(matrix, matrix, self.permutation(), x, Par::Seq, stack);
        }
    }

    fn solve_transposed(&self, x: &mut [f64]) {
        let scratch = solve::solve_transpose_in_place_scratch::<usize, f64>(x.len(), 1, Par::Seq);
        let x = MatMut::from_column_major_slice_mut(x, self.rows.len(), 1);
        let (matrix, stack) = (self.matrix(), &mut MemBuffer::new(scratch));
        solve::solve_transpose_in_place(
            matrix,
            matrix,
            self.permutation(),
            x,
            Par::Seq,
            MemStack::new(stack),
        );
    }
}

#[cfg(test)]
mod tests {
    use std::time::Instant;

    use super::*;

    #[test]
    fn transposed_solutions_satisfy_the_transposed_system() {
        for dim in [1, 3, 40, 1100] {
            // Zeros on the diagonal, so that rows are interchanged; unsymmetric.
            let entry = |i: usize, j: usize| match (i + 1) % dim == j {
                _ if dim > 1 && i == j => 0.0,
                true => 1.0,
                false => ((5 * i + 3 * j) % 11) as f64 / (20 * dim) as f64,
            };
            let matrix: Vec<f64> = (0..dim * dim).map(|k| entry(k % dim, k / dim)).collect();
            let settings = Settings::default();
            let halt = Halt::new(NAME, &settings, Instant::now());
            let factors = <Lu as Direct>::factor(matrix, dim, Threads::new(dim, 1), &halt).unwrap();
            let truth: Vec<f64> = (0..dim).map(|i| 1.0 + (i % 7) as f64).collect();
            let product = |j: usize| (0..dim).map(|i| entry(i, j) * truth[i]).sum::<f64>();
            let mut x: Vec<f64> = (0..dim).map(product).collect();
            factors.solve_transposed(&mut x);
            assert!(x.iter().zip(&truth).all(|(x, truth)| (x - truth).abs() < 1e-11), "{dim}");
        }
    }
}
