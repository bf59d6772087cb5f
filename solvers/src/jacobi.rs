//! Jacobi: relax all blocks at once with the old values of all the others.
//!
//! With D the block diagonal of A, or its diagonal,
//!
//!   x ← x + ω D⁻¹ (b − A x).
//!
//! For A = I − K with zero diagonal blocks in K and ω = 1 this is Neumann's series x = b + K b + K² b + ….
//! Converges for every first guess exactly if all eigenvalues of I − ω D⁻¹ A are below 1 in modulus: with
//! ω = 1 if A is strictly diagonally dominant (by single rows, coefficient by coefficient); for symmetric
//! positive definite A and D if 0 < ω < 2 / λ_max(D⁻¹ A). Reference: Y. Saad, *Iterative Methods for Sparse
//! Linear Systems*, 2nd ed., SIAM 2003, §4.1-4.2.

use crate::diagonal::Pivot;
use crate::error::SolveError;
use crate::operator::Operator;
use crate::problem::Problem;
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step};
use crate::sweeps::sweep;

pub(crate) const NAME: &str = "jacobi";

/// Jacobi, by block or by coefficient, damped or not; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Jacobi;

impl Solver for Jacobi {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let problem = Problem::new(a, b, x, settings)?;
        let pivots = Pivot::read_all(a, settings.granularity)?;
        sweep(NAME, &problem, pivots, x, settings, observer)
    }
}
