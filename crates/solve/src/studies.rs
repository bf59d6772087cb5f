//! Studies: sequences of runs for a wanted accuracy or for convergence, and the distance of two solutions.

pub mod error_norm;
pub mod adaptation;
pub mod convergence;
