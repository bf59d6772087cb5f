//! Weighted mass matrices of the Legendre basis.
//!
//!   M[m][n] = ∫₋₁¹ p_m p_n (1 − x)^α (1 + x)^β dx
//!
//! by the N-point Gauss rule of the weight, which is exact for the degree 2N − 2 of the product. For
//! α = β = 0 it is the identity; the Gram matrix of any weight on an edge, and by products on a square,
//! follows.

use crate::gauss::Rule;
use crate::jacobi::Weight;

/// `M[m][n]` = ∫₋₁¹ p_m p_n W dx for the first N polynomials.
///
/// # Panics
/// If an exponent is too near −1 for a rule of N points
/// ([`RuleError::NearEnd`](crate::gauss::RuleError::NearEnd)).
pub fn mass<const N: usize>(weight: Weight) -> [[f64; N]; N] {
    let rule = Rule::<N>::jacobi(weight);
    let mut matrix = [[0.0; N]; N];
    for (&x, &w) in rule.nodes.iter().zip(&rule.weights) {
        let mut p = [0.0; N];
        super::orthonormal(x, &mut p);
        for m in 0..N {
            for n in 0..N {
                matrix[m][n] += w * p[m] * p[n];
            }
        }
    }
    matrix
}
