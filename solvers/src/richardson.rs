//! Richardson: add the residual as it is; for A = I − K this is Neumann's series.
//!
//!   x ← x + ω (b − A x).
//!
//! From x = 0 and with ω = 1, the k-th iterate is the sum of the first k terms of
//!
//!   x = b + K b + K² b + … ,   K = I − A :
//!
//! of light that is reflected, one reflection more for each iteration. The error of the k-th iterate is (I − ω A)ᵏ times the
//! first one. Converges for every first guess exactly if all eigenvalues of I − ω A are below 1 in modulus: for symmetric
//! positive definite A if 0 < ω < 2 / λ_max(A). No diagonal block is read or inverted. References: L. F. Richardson, Phil.
//! Trans. R. Soc. A 210 (1911); Y. Saad, *Iterative Methods for Sparse Linear Systems*, 2nd ed., SIAM 2003, §4.2.

use crate::error::SolveError;
use crate::iteration::{Iteration, Watch, iterate};
use crate::operator::Operator;
use crate::problem::Problem;
use crate::settings::Settings;
use crate::solver::{Report, Solver, Step};
use crate::vector::add_scaled;

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
        let mut series = Series {
            problem: &problem,
            relaxation: settings.relaxation,
            r: vec![0.0; problem.dim()],
            products: 0.0,
        };
        let watch = Watch { method: NAME, limit: settings.max_iterations, patience: 100, keep_every: 1 };
        iterate(&problem, &watch, &mut series, x, settings, observer)
    }
}

struct Series<'p> {
    problem: &'p Problem<'p>,
    relaxation: f64,
    /// b − A x.
    r: Vec<f64>,
    products: f64,
}

impl Iteration for Series<'_> {
    fn renew(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        self.products += 1.0;
        self.problem.residual(x, &mut self.r)
    }

    fn advance(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        add_scaled(self.relaxation, &self.r, x);
        self.renew(x)
    }

    fn work(&self) -> f64 {
        self.products
    }

    fn columns(&self) -> usize {
        self.problem.a.partition().len()
    }
}
