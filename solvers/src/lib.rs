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

pub mod gauss_seidel;
#[cfg(feature = "faer")]
pub mod lu;
pub mod method;
pub mod southwell;

pub use dense::Dense;
pub use error::{SolveError, Stop};
pub use operator::Operator;
pub use partition::Partition;
pub use settings::{Granularity, Settings, Sweep};
pub use solver::{Report, Solver, Step};
