//! Gauss rules: n nodes and weights with ∫₋₁¹ f(x) W(x) dx = Σ wᵢ f(xᵢ) for every polynomial f of degree ≤ 2n − 1.

mod error;
mod jacobi;
mod laguerre;
mod legendre;
mod polish;
mod symmetric;

pub use self::error::RuleError;
pub use self::jacobi::jacobi;
pub use self::legendre::{Legendre, legendre};
