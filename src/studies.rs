//! Runs of runs: the difference of two solutions, a wanted accuracy, and convergence.

pub mod error_norm;
pub mod adaptation;
pub mod convergence;
