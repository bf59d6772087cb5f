//! Gauss rules: n nodes and weights with ∫₋₁¹ f(x) W(x) dx = Σ wᵢ f(xᵢ) for every polynomial f of
//! degree ≤ 2n − 1.
//!
//! | | weight | cost | nodes, weights | |
//! | --- | --- | --- | --- | --- |
//! | [`Legendre`], [`Jacobi`], [`Rule`] | any | none at run time | correctly rounded | `const` |
//! | [`legendre`], [`legendre_part`] | 1 | O(n²) | correctly rounded | `const fn` |
//! | [`legendre_asymptotic`] | 1, n > 100 | O(n) | 3 ulp, 4 ulp | |
//! | [`jacobi`](jacobi()) | (1 − x)^α (1 + x)^β | O(n²) | correctly rounded | `const fn` |

mod error;
mod asymptotic;
mod polish;
mod symmetric;
mod legendre;
mod trail;
mod laguerre;
mod jacobi;
mod rule;

pub use self::asymptotic::legendre_asymptotic;
pub use self::error::RuleError;
pub use self::jacobi::jacobi;
pub use self::legendre::{legendre, legendre_part};
pub use self::rule::{Jacobi, Legendre, Rule};
