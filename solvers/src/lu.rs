//! LU factorisation with partial pivoting.
//!
//! P A = L U in n³/3 multiplications, then two triangles per right-hand side; the residual of the solution is
//! recomputed and refined. Backward stable in practice for every nonsingular matrix. Reference: G. Golub, C.
//! Van Loan, *Matrix Computations*, 4th ed., Johns Hopkins 2013, §3.4.

use crate::direct::Direct;
use crate::error::SolveError;
use crate::factors::Factors;
use crate::lu_factors::LuFactors;
use crate::panel::Labour;
use crate::settings::Settings;

pub(crate) const NAME: &str = "lu";

/// LU with partial pivoting and refinement; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Lu;

impl Direct for Lu {
    const NAME: &'static str = NAME;

    const COST: f64 = 1.0 / 3.0;

    fn factor(matrix: Vec<f64>, dim: usize, settings: &Settings<'_>) -> Result<Box<dyn Factors>, SolveError> {
        let factors = LuFactors::new(matrix, dim, Labour::of(settings));
        let factors = factors.ok_or_else(|| SolveError::Singular { what: "the matrix".into() })?;
        Ok(Box::new(factors))
    }
}
