//! Restarted GMRES, preconditioned from the right by the diagonal blocks or not.
//!
//! With M = diag(A_BB), or M = I, r = b − A x and v₁ = r/‖r‖, the Arnoldi process builds an orthonormal v₁,
//! …, v_{j+1} with
//!
//!   A M⁻¹ V_j = V_{j+1} H_j,   H_j of j+1 rows, upper Hessenberg,
//!
//! by modified Gram–Schmidt, done twice. Givens rotations keep H_j triangular, and the last entry of the
//! rotated ‖r‖ e₁ is the residual of the best x + M⁻¹ V_j y, y minimising ‖ ‖r‖ e₁ − H_j y ‖₂. After m steps
//! x is updated, the residual recomputed, and the process restarts. A block without inverse is not
//! preconditioned.
//!
//! The residual never rises. Without restart it vanishes after at most n steps for every invertible A; with
//! restarts it is certain to only if the symmetric part of A M⁻¹ is positive definite, and may stand still
//! otherwise. Reference: Y. Saad, *Iterative Methods for Sparse Linear Systems*, 2nd ed., SIAM 2003, §6.5,
//! §9.3.2.

use crate::diagonal::Pivot;
use crate::error::SolveError;
use crate::iteration::{Iteration, Watch, iterate};
use crate::operator::Operator;
use crate::problem::Problem;
use crate::settings::{Granularity, Preconditioner, Settings};
use crate::solver::{Report, Solver, Step};
use crate::tolerances::VANISHED;
use crate::vector::{add_scaled, dot, norm};

pub(crate) const NAME: &str = "gmres";

/// Restarted GMRES, with a block-Jacobi preconditioner unless none is wanted; see the [module](self).
#[derive(Clone, Copy, Debug, Default)]
pub struct Gmres;

impl Solver for Gmres {
    fn solve(
        &self,
        a: &dyn Operator,
        b: &[f64],
        x: &mut [f64],
        settings: &Settings<'_>,
        observer: &mut dyn FnMut(&Step<'_>),
    ) -> Result<Report, SolveError> {
        let problem = Problem::new(a, b, x, settings)?;
        let mut arnoldi = Arnoldi {
            problem: &problem,
            pivots: pivots(a, settings.preconditioner)?,
            restart: settings.restart,
            r: vec![0.0; problem.dim()],
            residual: f64::INFINITY,
            basis: Vec::new(),
            columns: Vec::new(),
            rotations: Vec::new(),
            target: Vec::new(),
            advances: 0,
            products: 0.0,
        };
        let patience = 2 * settings.restart.min(problem.dim()) + 100;
        let watch =
            Watch { method: NAME, limit: settings.max_iterations, asked: None, patience, keep_every: 1 };
        iterate(&problem, &watch, &mut arnoldi, x, settings, observer)
    }
}

/// The inverses of all diagonal blocks; none where nothing preconditions.
fn pivots(a: &dyn Operator, preconditioner: Preconditioner) -> Result<Vec<Option<Pivot>>, SolveError> {
    match preconditioner {
        Preconditioner::Block => (0..a.partition().len()).map(|block| pivot(a, block)).collect(),
        Preconditioner::None => Ok(Vec::new()),
    }
}

/// The inverse of a diagonal block, none if it has none.
fn pivot(a: &dyn Operator, block: usize) -> Result<Option<Pivot>, SolveError> {
    match Pivot::read(a, block, Granularity::Block) {
        Err(SolveError::Singular { .. }) => Ok(None),
        pivot => pivot.map(Some),
    }
}

struct Arnoldi<'p> {
    problem: &'p Problem<'p>,
    pivots: Vec<Option<Pivot>>,
    restart: usize,
    /// b − A x for the x of the last restart, and its relative size.
    r: Vec<f64>,
    residual: f64,
    /// v₁, …, v_{j+1}.
    basis: Vec<Vec<f64>>,
    /// The triangle of the rotated H_j, column by column.
    columns: Vec<Vec<f64>>,
    /// Cosine and sine of each rotation.
    rotations: Vec<(f64, f64)>,
    /// The rotated ‖r‖ e₁.
    target: Vec<f64>,
    advances: usize,
    products: f64,
}

/// A vector made orthogonal to a basis.
struct Orthogonalised {
    remainder: Vec<f64>,
    /// The column of H_j without its last entry: what was taken off along each vector of the basis.
    column: Vec<f64>,
    /// Length before.
    length: f64,
}

impl Arnoldi<'_> {
    /// v := M⁻¹ v.
    fn precondition(&self, v: &mut [f64]) {
        for (block, pivot) in self.pivots.iter().enumerate() {
            if let Some(pivot) = pivot {
                pivot.divide(&mut v[self.problem.a.partition().range(block)]);
            }
        }
    }

    /// M⁻¹ V y for the y that minimises the residual.
    fn correction(&self) -> Vec<f64> {
        let mut y = self.target.clone();
        let mut correction = vec![0.0; self.problem.dim()];
        for (j, column) in self.columns.iter().enumerate().rev() {
            // A direction that A maps to nothing new cannot help.
            y[j] = if column[j] == 0.0 { 0.0 } else { y[j] / column[j] };
            let yj = y[j];
            add_scaled(-yj, &column[..j], &mut y[..j]);
            add_scaled(yj, &self.basis[j], &mut correction);
        }
        self.precondition(&mut correction);
        correction
    }

    /// Restarts from r.
    fn restart(&mut self) {
        let size = norm(&self.r);
        self.basis = vec![self.r.iter().map(|r| r / size).collect()];
        self.columns.clear();
        self.rotations.clear();
        self.target = vec![size];
    }

    /// A M⁻¹ v_j made orthogonal to v₁, …, v_j.
    fn orthogonalise(&mut self) -> Result<Orthogonalised, SolveError> {
        let mut direction = self.basis[self.columns.len()].clone();
        self.precondition(&mut direction);
        let mut w = vec![0.0; direction.len()];
        self.problem.apply(&direction, &mut w)?;
        self.products += 1.0;
        let length = norm(&w);
        let mut column = vec![0.0; self.basis.len()];
        // Once is not enough when A M⁻¹ v lies almost in the span already; twice is.
        for _ in 0..2 {
            for (h, v) in column.iter_mut().zip(&self.basis) {
                let along = dot(v, &w);
                add_scaled(-along, v, &mut w);
                *h += along;
            }
        }
        Ok(Orthogonalised { remainder: w, column, length })
    }

    /// Rotates a new column of H_j, whose last entry is `below`, into the triangle.
    fn rotate(&mut self, mut column: Vec<f64>, below: f64) {
        for (i, (c, s)) in self.rotations.iter().enumerate() {
            (column[i], column[i + 1]) =
                (c * column[i] + s * column[i + 1], c * column[i + 1] - s * column[i]);
        }
        let last = column.len() - 1;
        let length = column[last].hypot(below);
        let (c, s) = if length == 0.0 { (1.0, 0.0) } else { (column[last] / length, below / length) };
        column[last] = length;
        self.columns.push(column);
        self.rotations.push((c, s));
        let target = self.target[last];
        self.target[last] = c * target;
        self.target.push(-s * target);
    }
}

impl Iteration for Arnoldi<'_> {
    fn renew(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        let mut next = x.to_vec();
        let pending = !self.columns.is_empty();
        if pending {
            add_scaled(1.0, &self.correction(), &mut next);
        }
        let mut r = vec![0.0; x.len()];
        let residual = self.problem.residual(&next, &mut r)?;
        self.products += 1.0;
        // Rounding may have made x worse: it then stays as it was.
        if !pending || residual < self.residual {
            x.copy_from_slice(&next);
            self.r = r;
            self.residual = residual;
        }
        self.restart();
        Ok(self.residual)
    }

    fn advance(&mut self, x: &mut [f64]) -> Result<f64, SolveError> {
        let Orthogonalised { remainder: mut w, column, length } = self.orthogonalise()?;
        self.advances += 1;
        let below = norm(&w);
        let vanished = below <= VANISHED * length;
        self.rotate(column, if vanished { 0.0 } else { below });
        if vanished {
            let (before, stuck) =
                (self.residual, self.columns.last().is_some_and(|column| column.ends_with(&[0.0])));
            let residual = self.renew(x)?;
            if stuck && residual >= before {
                return Err(SolveError::Breakdown { method: NAME, iterations: self.advances });
            }
            return Ok(residual);
        }
        if self.columns.len() == self.restart {
            return self.renew(x);
        }
        w.iter_mut().for_each(|w| *w /= below);
        self.basis.push(w);
        Ok(self.target[self.columns.len()].abs() / self.problem.norm)
    }

    fn work(&self) -> f64 {
        self.products
    }

    fn columns(&self) -> usize {
        self.problem.a.partition().len()
    }
}
