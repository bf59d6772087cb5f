//! Cholesky factorisation, by faer.
//!
//! A = L Lᵀ in n³/6 multiplications from the lower triangle of A alone, half of what LU takes. The residual
//! is recomputed with all of A and refined; where that does not reach the tolerance (a matrix that is not as
//! symmetric as it claims, or factors gone wrong) LU takes over. L exists exactly if the lower triangle is
//! that of a symmetric positive definite matrix; any other is refused. The columns are taken in panels, of
//! which the first is factored and the rest updated,
//!
//!   A₁₁ = L₁₁ L₁₁ᵀ,   L₂₁ = A₂₁ L₁₁⁻ᵀ,   A₂₂ ← A₂₂ − L₂₁ L₂₁ᵀ.
//!
//! Reference: N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., SIAM 2002, ch. 10.

use std::time::Instant;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor;
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Accum, MatMut, MatRef};

use crate::bundle::{Bundle, COLUMNS};
use crate::direct::Direct;
use crate::error::{SolveError, Stop};
use crate::factored::Factored;
use crate::factors::Factors;
use crate::halt::Halt;
use crate::lu::Lu;
use crate::operator::Operator;
use crate::panel::{PANEL, Threads};
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step};

pub(crate) const NAME: &str = "cholesky";

/// Cholesky with refinement, LU where that fails; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Cholesky;

impl Cholesky {
    /// Factors `a` once, to solve with it often; without the fall-back to LU.
    ///
    /// # Errors
    /// [`SolveError::NotSymmetric`] if the operator does not claim to be,
    /// [`SolveError::NotPositiveDefinite`], and those of [`Lu::factor`] but [`SolveError::Singular`].
    pub fn factor<'a>(
        &self,
        a: &'a dyn Operator,
        settings: &Settings<'a>,
    ) -> Result<Factored<'a>, SolveError> {
        require_symmetric(a)?;
        Factored::new::<LowerTriangle>(a, settings)
    }
}

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

    fn factor(
        mut matrix: Vec<f64>,
        dim: usize,
        threads: Threads,
        halt: &Halt<'_>,
    ) -> Result<Box<dyn Factors>, SolveError> {
        factor_panels(&mut matrix, dim, threads, halt)?;
        Ok(Box::new(Triangle { matrix, dim }))
    }
}

/// A = L Lᵀ in place, panel by panel.
fn factor_panels(
    matrix: &mut [f64],
    dim: usize,
    threads: Threads,
    halt: &Halt<'_>,
) -> Result<(), SolveError> {
    for start in (0..dim).step_by(PANEL) {
        halt.check_factoring()?;
        let width = PANEL.min(dim - start);
        let (panel, right) = matrix[start * dim..].split_at_mut(width * dim);
        let panel = MatMut::from_column_major_slice_mut(panel, dim, width).split_at_row_mut(start).1;
        let (mut diagonal, mut below) = panel.split_at_row_mut(width);
        factor_diagonal(diagonal.as_mut(), threads)?;
        // B ← B L⁻ᵀ: the rows of B are the right-hand sides.
        let par = threads.for_columns(below.nrows());
        solve_lower_triangular_in_place(diagonal.as_ref(), below.as_mut().transpose_mut(), par);
        for (chunk, columns) in right.chunks_mut(PANEL * dim).enumerate() {
            halt.check_factoring()?;
            let count = columns.len() / dim;
            let (_, below) = below.as_ref().split_at_row(chunk * PANEL);
            let top = start + width + chunk * PANEL;
            let columns = MatMut::from_column_major_slice_mut(columns, dim, count).split_at_row_mut(top).1;
            subtract_square(below, columns, threads);
        }
    }
    Ok(())
}

/// A₁₁ = L₁₁ L₁₁ᵀ in place, of the lower triangle.
fn factor_diagonal(diagonal: MatMut<'_, f64>, threads: Threads) -> Result<(), SolveError> {
    let dim = diagonal.nrows();
    let par = threads.for_columns(dim);
    let scratch = factor::cholesky_in_place_scratch::<f64>(dim, par, Default::default());
    let stack = &mut MemBuffer::new(scratch);
    let factored = factor::cholesky_in_place(
        diagonal,
        Default::default(),
        par,
        MemStack::new(stack),
        Default::default(),
    );
    factored.map(|_| ()).map_err(|_| SolveError::NotPositiveDefinite { method: NAME })
}

/// C ← C − B B₁ᵀ on and below the diagonal, where B₁ has the first rows of B, as many as C has columns.
fn subtract_square(b: MatRef<'_, f64>, c: MatMut<'_, f64>, threads: Threads) {
    let par = threads.for_columns(c.ncols());
    let (first, rest) = b.split_at_row(c.ncols());
    let (square, below) = c.split_at_row_mut(first.nrows());
    let (lower, whole) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
    triangular::matmul(square, lower, Accum::Add, first, whole, first.transpose(), whole, -1.0, par);
    matmul(below, Accum::Add, rest, first.transpose(), -1.0, par);
}

/// L on and below the diagonal; the entries above are of no meaning.
struct Triangle {
    /// Entry (i, j) at `matrix[j·dim + i]`.
    matrix: Vec<f64>,
    dim: usize,
}

impl Factors for Triangle {
    fn solve(&self, x: &mut [f64]) {
        let matrix = MatRef::from_column_major_slice(&self.matrix, self.dim, self.dim);
        for columns in x.chunks_mut(COLUMNS * self.dim.max(1)) {
            let mut bundle = Bundle::of(columns, self.dim);
            bundle.solve_lower(matrix);
            bundle.solve_transposed(matrix);
            bundle.write(columns);
        }
    }

    fn solve_transposed(&self, x: &mut [f64]) {
        self.solve(x);
    }
}
