//! Jacobi polynomials: orthogonal on [−1, 1] for the weight (1 − x)^α (1 + x)^β, α, β > −1.

mod integral;
mod anchored;
pub(crate) mod monic;
mod polynomials;
mod table;
mod weight;

pub(crate) use self::integral::integral;
pub use self::polynomials::{Polynomials, orthonormal};
pub use self::table::{Entry, Table};
pub use self::weight::{Weight, WeightError};
