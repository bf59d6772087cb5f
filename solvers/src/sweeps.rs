//! Sweeps x ← x + ω D⁻¹ (b − A x): what the methods of Jacobi and Richardson have in common.

use crate::diagonal::Pivot;
use crate::error::SolveError;
use crate::iteration::{Iteration, Watch, iterate};
use crate::problem::Problem;
use crate::settings::Settings;
use crate::solver::{Report, Step};
use crate::vector::add_scaled;

/// Sweeps until the residual of `problem` is small enough, as `method`; D is given by `pivots`, one for each
/// block, or is 1 where there are none.
pub(crate) fn sweep(
    method: &'static str,
    problem: &Problem<'_>,
    pivots: Vec<Pivot>,
    x: &mut [f64],
    settings: &Settings<'_>,
    observer: &mut dyn FnMut(&Step<'_>),
) -> Result<Report, SolveError> {
    let (relaxation, r) = (settings.relaxation, vec![0.0; problem.dim()]);
    let mut sweeps = Sweeps { problem, pivots, relaxation, r, products: 0.0 };
    let watch = Watch { method, limit: settings.max_iterations, asked: None, patience: 100, keep_every: 1 };
    iterate(problem, &watch, &mut sweeps, x, settings, observer)
}

struct Sweeps<'p> {
    problem: &'p Problem<'p>,
    pivots: Vec<Pivot>,
    relaxation: f64,
    /// b − A x.
    r: Vec<f64>,
    products: f64,
}

impl Iteration for Sweeps<'_> {
    fn renew(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        self.products += 1.0;
        self.problem.residual(x, &mut self.r)
    }

    fn advance(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        Pivot::divide_all(&self.pivots, self.problem.a.partition(), &mut self.r);
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
