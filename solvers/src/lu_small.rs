//! LU factorisation with partial pivoting, plain and single-threaded.
//!
//! The same method as `lu` from an independent library: a cross-check, and the direct method of builds
//! without the `faer` feature. Unblocked, so bound by memory: for at most some 1000 unknowns.

use nalgebra::{DMatrix, DMatrixViewMut, Dyn, LU};

use crate::direct::Direct;
use crate::error::SolveError;
use crate::factors::Factors;
use crate::operator::Operator;
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step};

/// Name in the list of methods.
pub(crate) const NAME: &str = "lu-small";

/// The method, ready to be run.
const DIRECT: Direct = Direct { method: NAME, cost: 1.0 / 3.0, lower: false, factor };

/// Unblocked LU with refinement; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct LuSmall;

impl Solver for LuSmall {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        DIRECT.solve(a, b, x, settings, observer)
    }

    fn solve_many(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Vec<Report>, SolveError> {
        DIRECT.solve_many(a, b, x, settings, observer)
    }
}

/// P A = L U.
fn factor(matrix: Vec<f64>, dim: usize, _: &Settings<'_>) -> Result<Box<dyn Factors>, SolveError> {
    let lu = DMatrix::from_vec(dim, dim, matrix).lu();
    if lu.is_invertible() {
        Ok(Box::new(lu))
    } else {
        Err(SolveError::Singular { what: "the matrix".into() })
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
