//! Gauss–Seidel: relax each block with the newest values of all the others.
//!
//! With D_B the diagonal block and r_B = b_B − (A x)_B taken at the moment of the visit,
//!
//!   x_B ← x_B + ω D_B⁻¹ r_B        for every block B, in order (and backwards, for a symmetric sweep).
//!
//! Coefficient by coefficient, r_B is gathered once and then kept up to date inside the block:
//!
//!   δ = ω r_k / d_kk,   x_k ← x_k + δ,   r_B ← r_B − δ D_B e_k.
//!
//! Converges for every first guess if A is symmetric positive definite and 0 < ω < 2 (Ostrowski–Reich), or
//! with ω = 1 if A is strictly diagonally dominant by rows. Reference: Y. Saad, *Iterative Methods for Sparse
//! Linear Systems*, 2nd ed., SIAM 2003, §4.1-4.2.

use crate::diagonal::Pivot;
use crate::error::SolveError;
use crate::iteration::{Iteration, Watch, iterate};
use crate::operator::Operator;
use crate::problem::{Problem, finite};
use crate::settings::{Settings, Sweep};
use crate::solver::{Report, Solver, Step};
use crate::vector::{add_scaled, norm};

pub(crate) const NAME: &str = "gauss-seidel";

/// Gauss–Seidel and successive overrelaxation, by block or by coefficient; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct GaussSeidel;

impl Solver for GaussSeidel {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let problem = Problem::new(a, b, x, settings)?;
        let mut sweeps = Sweeps {
            problem: &problem,
            pivots: Pivot::read_all(a, settings.granularity)?,
            relaxation: settings.relaxation,
            symmetric: settings.sweep == Sweep::Symmetric,
            r: vec![0.0; problem.dim()],
            products: 0.0,
        };
        let watch =
            Watch { method: NAME, limit: settings.max_iterations, asked: None, patience: 100, keep_every: 1 };
        iterate(&problem, &watch, &mut sweeps, x, settings, observer)
    }
}

struct Sweeps<'p> {
    problem: &'p Problem<'p>,
    pivots: Vec<Pivot>,
    relaxation: f64,
    symmetric: bool,
    /// Residual of each block when it was last visited.
    r: Vec<f64>,
    products: f64,
}

impl Sweeps<'_> {
    /// Relaxes the unknowns of one block.
    fn visit(&mut self, block: usize, backwards: bool, x: &mut [f64]) -> Result<(), SolveError> {
        let range = self.problem.a.partition().range(block);
        let r = &mut self.r[range.clone()];
        r.fill(f64::NAN);
        self.problem.a.gather(block, x, r);
        finite(r)?;
        for (r, b) in r.iter_mut().zip(&self.problem.b[range.clone()]) {
            *r = b - *r;
        }
        let mut left = r.to_vec();
        match &self.pivots[block] {
            Pivot::Coefficients(d) => relax_each(d, self.relaxation, backwards, &mut left, &mut x[range]),
            pivot => {
                pivot.divide(&mut left);
                add_scaled(self.relaxation, &left, &mut x[range]);
            }
        }
        Ok(())
    }
}

/// Relaxes the unknowns `x` of a block with diagonal block `d` and residual `r` one after the other.
fn relax_each(d: &[f64], relaxation: f64, backwards: bool, r: &mut [f64], x: &mut [f64]) {
    let size = r.len();
    for turn in 0..size {
        let k = if backwards { size - 1 - turn } else { turn };
        let step = relaxation * r[k] / d[k * size + k];
        x[k] += step;
        add_scaled(-step, &d[k * size..][..size], r);
    }
}

impl Iteration for Sweeps<'_> {
    fn renew(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        self.products += 1.0;
        self.problem.residual(x, &mut self.r)
    }

    fn advance(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        for block in 0..self.pivots.len() {
            self.visit(block, false, x)?;
        }
        self.products += 1.0;
        if self.symmetric {
            for block in (0..self.pivots.len()).rev() {
                self.visit(block, true, x)?;
            }
            self.products += 1.0;
        }
        Ok(norm(&self.r) / self.problem.norm)
    }

    fn work(&self) -> f64 {
        self.products
    }

    fn columns(&self) -> usize {
        self.pivots.len()
    }
}
