//! Interchangeable solvers for dense block systems, each with an honest residual.

mod partition;

mod error;
mod settings;
mod vector;

mod operator;

mod dense;

mod problem;

mod solver;

mod condition;
mod diagonal;
mod direct;
mod iteration;
mod ranking;

#[cfg(feature = "faer")]
pub mod lu;

#[cfg(feature = "faer")]
pub mod cholesky;
pub mod lu_small;

pub mod jacobi;

pub mod gauss_seidel;

pub mod southwell;

pub mod cg;

pub mod gmres;

pub mod auto;

pub mod method;

pub use dense::Dense;
pub use error::{SolveError, Stop};
pub use operator::Operator;
pub use partition::Partition;
pub use settings::{Granularity, Settings, Sweep};
pub use solver::{Report, Solver, Step};
