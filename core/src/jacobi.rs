//! Jacobi polynomials: orthogonal on [−1, 1] for the weight (1 − x)^α (1 + x)^β, α, β > −1.

pub(crate) mod monic;
mod weight;

pub use self::weight::{Weight, WeightError};
