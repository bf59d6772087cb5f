//! LU factorisation with partial pivoting, plain and single-threaded.
//!
//! The same method as `lu` from an independent library: a cross-check, and the direct method of builds without the
//! `faer` feature. It is unblocked and bound by memory: measured 1.5 times slower than `lu` at 500 unknowns, 4.4 times
//! at 1500, 19 times at 3000.

use nalgebra::{DMatrix, DMatrixViewMut, Dyn, LU};

use crate::direct::Direct;
use crate::error::SolveError;
use crate::factors::Factors;
use crate::settings::Settings;

pub(crate) const NAME: &str = "lu-small";

/// Unblocked LU with refinement; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct LuSmall;

impl Direct for LuSmall {
    const NAME: &'static str = NAME;

    const COST: f64 = 1.0 / 3.0;

    /// P A = L U.
    fn factor(matrix: Vec<f64>, dim: usize, _: &Settings<'_>) -> Result<Box<dyn Factors>, SolveError> {
        let lu = DMatrix::from_vec(dim, dim, matrix).lu();
        if lu.is_invertible() {
            Ok(Box::new(lu))
        } else {
            Err(SolveError::Singular { what: "the matrix".into() })
        }
    }
}

impl Factors for LU<f64, Dyn, Dyn> {
    fn solve(&self, x: &mut [f64]) {
        let rows = x.len();
        self.solve_mut(&mut DMatrixViewMut::from_slice(x, rows, 1));
    }

    fn solve_transposed(&self, x: &mut [f64]) {
        // Aᵀ = Uᵀ Lᵀ P.
        let rows = x.len();
        let mut x = DMatrixViewMut::from_slice(x, rows, 1);
        self.lu_internal().tr_solve_upper_triangular_mut(&mut x);
        self.l().tr_solve_lower_triangular_mut(&mut x);
        self.p().inv_permute_rows(&mut x);
    }
}
