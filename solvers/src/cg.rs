//! Conjugate gradients, preconditioned by the diagonal blocks or not.
//!
//! With M = diag(A_BB), or M = I, r₀ = b − A x₀, p₀ = z₀ = M⁻¹ r₀:
//!
//!   α = rᵀz / pᵀAp,   x ← x + α p,   r ← r − α A p,   z = M⁻¹ r,   β = rᵀz (new) / rᵀz (old),   p ← z + β p.
//!
//! Each x minimises (x − x*)ᵀ A (x − x*) over a growing space; after k steps this is at most
//!
//!   4 ((√κ − 1) / (√κ + 1))²ᵏ
//!
//! times the initial value, κ = κ₂(M⁻¹ A). Rounding makes the r of the recurrence drift away from b − A x.
//! When r has fallen by 10¹⁴, and before success is reported, it is recomputed and the directions restart.
//! Converges for every symmetric positive definite A; pᵀAp ≤ 0 refutes that. Symmetry itself is tested by one
//! probe, vᵀ(A p₀) = p₀ᵀ(A v) for a scattered v. Reference: Y. Saad, *Iterative Methods for Sparse Linear
//! Systems*, 2nd ed., SIAM 2003, §6.7, §9.2.

use nalgebra::{Cholesky, DMatrix, DVectorViewMut, Dyn};

use crate::diagonal::diagonal_block;
use crate::error::SolveError;
use crate::iteration::{Iteration, Watch, iterate};
use crate::operator::Operator;
use crate::problem::Problem;
use crate::settings::{Preconditioner, Settings};
use crate::solver::{Report, Solver, Step};
use crate::tolerances::{ASYMMETRY_OF_PRODUCTS, DRIFT};
use crate::vector::{add_scaled, dot, norm};

pub(crate) const NAME: &str = "cg";

/// Conjugate gradients, with a block-Jacobi preconditioner unless none is wanted; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Cg;

impl Solver for Cg {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let problem = Problem::new(a, b, x, settings)?;
        if !a.symmetric() {
            return Err(SolveError::NotSymmetric { method: NAME });
        }
        let mut descent = Descent {
            problem: &problem,
            blocks: factors(a, settings.preconditioner)?,
            r: vec![0.0; problem.dim()],
            renewed: 0.0,
            direction: None,
            probed: false,
            advances: 0,
            products: 0.0,
        };
        // The residual of a conjugate gradient may rise for long before it falls.
        let patience = 5 * problem.dim() + 100;
        let watch =
            Watch { method: NAME, limit: settings.max_iterations, asked: None, patience, keep_every: 1 };
        iterate(&problem, &watch, &mut descent, x, settings, observer)
    }
}

/// L of a diagonal block L Lᵀ.
type Factor = Cholesky<f64, Dyn>;

/// The factors of all diagonal blocks; none where nothing preconditions.
fn factors(a: &dyn Operator, preconditioner: Preconditioner) -> Result<Vec<Factor>, SolveError> {
    match preconditioner {
        Preconditioner::Block => (0..a.partition().len()).map(|block| factor(a, block)).collect(),
        Preconditioner::None => Ok(Vec::new()),
    }
}

/// A_BB = L Lᵀ.
fn factor(a: &dyn Operator, block: usize) -> Result<Factor, SolveError> {
    let size = a.partition().size(block);
    let factor = Cholesky::new(DMatrix::from_vec(size, size, diagonal_block(a, block)?));
    factor.ok_or(SolveError::NotPositiveDefinite { method: NAME })
}

/// A search direction p with its rᵀz.
struct Direction {
    p: Vec<f64>,
    rz: f64,
}

struct Descent<'p> {
    problem: &'p Problem<'p>,
    blocks: Vec<Factor>,
    r: Vec<f64>,
    /// Relative residual when `r` was last recomputed.
    renewed: f64,
    /// Absent after a renewal.
    direction: Option<Direction>,
    /// Whether symmetry has been put to the probe.
    probed: bool,
    advances: usize,
    products: f64,
}

impl Descent<'_> {
    /// z = M⁻¹ r and rᵀz.
    fn precondition(&self) -> Result<(Vec<f64>, f64), SolveError> {
        let mut z = self.r.clone();
        for (block, factor) in self.blocks.iter().enumerate() {
            let own = &mut z[self.problem.a.partition().range(block)];
            let size = own.len();
            factor.solve_mut(&mut DVectorViewMut::from_slice(own, size));
        }
        let rz = dot(&self.r, &z);
        if rz > 0.0 && rz.is_finite() { Ok((z, rz)) } else { Err(self.broken()) }
    }

    /// q = A p.
    fn multiply(&mut self, p: &[f64]) -> Result<Vec<f64>, SolveError> {
        let mut q = vec![0.0; p.len()];
        self.problem.apply(p, &mut q)?;
        self.products += 1.0;
        Ok(q)
    }

    /// Compares vᵀ q with pᵀ (A v), where q = A p, for a v without structure.
    fn probe(&mut self, p: &[f64], q: &[f64]) -> Result<(), SolveError> {
        let scattered = |i: usize| (i as f64 * 0.618_033_988_749_895).fract() - 0.5;
        let v: Vec<f64> = (1..=p.len()).map(scattered).collect();
        let image = self.multiply(&v)?;
        let scale = norm(&v) * norm(q) + norm(p) * norm(&image);
        self.probed = true;
        if (dot(&v, q) - dot(p, &image)).abs() <= ASYMMETRY_OF_PRODUCTS * scale {
            return Ok(());
        }
        Err(SolveError::NotSymmetric { method: NAME })
    }

    fn broken(&self) -> SolveError {
        SolveError::Breakdown { method: NAME, iterations: self.advances }
    }
}

impl Iteration for Descent<'_> {
    fn renew(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        self.products += 1.0;
        self.direction = None;
        self.renewed = self.problem.residual(x, &mut self.r)?;
        Ok(self.renewed)
    }

    fn advance(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        let Direction { mut p, rz } = match self.direction.take() {
            Some(direction) => direction,
            None => self.precondition().map(|(p, rz)| Direction { p, rz })?,
        };
        let q = self.multiply(&p)?;
        if !self.probed {
            self.probe(&p, &q)?;
        }
        let curvature = dot(&p, &q);
        if curvature <= 0.0 {
            return Err(SolveError::NotPositiveDefinite { method: NAME });
        }
        let step = rz / curvature;
        if !step.is_finite() {
            return Err(self.broken());
        }
        self.advances += 1;
        add_scaled(step, &p, x);
        add_scaled(-step, &q, &mut self.r);
        let residual = self.problem.relative(&self.r);
        if residual <= DRIFT * self.renewed {
            return self.renew(x);
        }
        let (z, next) = self.precondition()?;
        for (p, z) in p.iter_mut().zip(&z) {
            *p = z + next / rz * *p;
        }
        self.direction = Some(Direction { p, rz: next });
        Ok(residual)
    }

    fn work(&self) -> f64 {
        self.products
    }

    fn columns(&self) -> usize {
        self.problem.a.partition().len()
    }
}
