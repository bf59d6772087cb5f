//! Richardson: add the residual as it is; for A = I − K this is Neumann's series.
//!
//!   x ← x + ω (b − A x).
//!
//! From x = 0 and with ω = 1, the k-th iterate is the sum of the first k terms of
//!
//!   x = b + K b + K² b + … ,   K = I − A :
//!
//! of light that is reflected, one reflection more for each iteration. The error of the k-th iterate is
//! (I − ω A)ᵏ times the first one. Converges for every first guess exactly if all eigenvalues of I − ω A are
//! below 1 in modulus: for symmetric positive definite A if 0 < ω < 2 / λ_max(A). No diagonal block is read
//! or inverted. References: L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911); Y. Saad, *Iterative Methods
//! for Sparse Linear Systems*, 2nd ed., SIAM 2003, §4.2.

use crate::error::SolveError;
use crate::operator::Operator;
use crate::problem::Problem;
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step};
use crate::sweeps::sweep;

pub(crate) const NAME: &str = "richardson";

/// Richardson's iteration, damped or not; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Richardson;

impl Solver for Richardson {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let problem = Problem::new(a, b, x, settings)?;
        sweep(NAME, &problem, Vec::new(), x, settings, observer)
    }
}
