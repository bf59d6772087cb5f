//! Interchangeable solvers for dense block systems A x = b, each with an honest residual.
//!
//! A matrix is an [`Operator`]: blocks of unknowns, a product, block rows (*gather*) and block columns
//! (*shoot*). [`Dense`] holds one entry by entry; a caller's own type may compute its columns when they are
//! first shot. A [`Method`](method::Method) is found by name and keeps one contract, [`Solver`]: Ok means
//! that ‖b − A x‖₂ / ‖b‖₂, recomputed from A, b and x, is at most the tolerance; otherwise [`SolveError`]
//! says why, names the cure, and the best x there was is left to the caller. Results do not depend on the
//! number of threads, bit for bit.
//!
//! ```
//! use radiosity_solvers::{Operator, Partition, Settings, method::Method};
//!
//! /// I − K with k_ij = gain / dim: all send the same to all. No matrix is stored.
//! struct Even { blocks: Partition, gain: f64 }
//!
//! impl Operator for Even {
//!     fn partition(&self) -> &Partition { &self.blocks }
//!
//!     fn gather(&self, row: usize, x: &[f64], y: &mut [f64]) {
//!         let received = self.gain * x.iter().sum::<f64>() / self.blocks.dim() as f64;
//!         y.iter_mut().zip(&x[self.blocks.range(row)]).for_each(|(y, x)| *y = x - received);
//!     }
//!
//!     fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
//!         let sent = self.gain * x.iter().sum::<f64>() / self.blocks.dim() as f64;
//!         y.iter_mut().for_each(|y| *y -= sent);
//!         y[self.blocks.range(column)].iter_mut().zip(x).for_each(|(y, x)| *y += x);
//!     }
//!
//!     fn symmetric(&self) -> bool { true }
//! }
//!
//! let a = Even { blocks: Partition::new(&[3, 1, 4]), gain: 0.5 };
//! for method in Method::ALL {
//!     let mut x = [0.0; 8];
//!     let report = method.solver.solve(&a, &[1.0; 8], &mut x, &Settings::default(), &mut |_| ())?;
//!     assert!(report.residual <= 1e-8 && x.iter().all(|x| (x - 2.0).abs() < 1e-7));
//! }
//! # Ok::<(), radiosity_solvers::SolveError>(())
//! ```
//!
//! # Which method when
//!
//! | method | when | converges |
//! | --- | --- | --- |
//! | [`auto`] | not sure | where one of its choices does |
//! | [`cholesky`] | symmetric positive definite, up to some thousand unknowns | A = Aᵀ, xᵀAx > 0, ε κ(A) < 1 |
//! | [`lu`] | anything else of that size | A invertible, ε κ(A) < 1 |
//! | [`cg`] | symmetric positive definite, large or never stored | A = Aᵀ, xᵀAx > 0; in O(√κ) steps |
//! | [`gmres`] | unsymmetric, large or never stored | A invertible, if not restarted |
//! | [`gauss_seidel`] `gauss-seidel` | rows one by one; little memory | A = Aᵀ, xᵀAx > 0; or A dominant by rows |
//! | [`jacobi`] | the plainest method: Neumann's series | all \|λ(I − ω D⁻¹A)\| < 1; or A dominant by rows |
//! | [`richardson`] | A = I − K as it is: the terms of Neumann's series one by one | all \|λ(I − ω A)\| < 1 |
//! | [`southwell`] | expensive columns, few of which matter | A = Aᵀ, xᵀAx > 0; or A dominant by columns |
//!
//! The exact conditions and the references stand in each module's header.

mod tolerances;

mod partition;

mod error;

mod settings;

mod operator;

mod vector;

mod bundle;

mod dense;

mod block_sparse;

mod functional;

mod problem;

mod solver;

mod iteration;

mod factors;

mod halt;

mod panel;

mod diagonal;

mod ranking;

mod condition;

mod direct;

mod factored;

mod sweeps;

pub mod lu;

pub mod cholesky;

pub mod jacobi;

pub mod richardson;

pub mod gauss_seidel;

pub mod southwell;

pub mod cg;

pub mod gmres;

pub mod auto;

pub mod method;

pub use block_sparse::{BlockSparse, SparseBlock};
pub use dense::Dense;
pub use error::{SolveError, Stop};
pub use factored::Factored;
pub use functional::functional;
pub use operator::Operator;
pub use partition::Partition;
pub use settings::{Granularity, Preconditioner, Settings, Sweep};
pub use solver::{Report, Solver, Step};
