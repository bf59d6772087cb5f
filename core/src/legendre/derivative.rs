//! The derivative in the Legendre basis.
//!
//!   p_n′ = Σ_k D[n][k] p_k,   D[n][k] = 2 √((n + ½)(k + ½)) for k < n with n − k odd, else 0
//!
//! Reference: NIST Digital Library of Mathematical Functions, 18.9.20 summed over k.

use crate::math::const_sqrt;

/// D with p_n′ = Σ_k `D[n][k]` p_k: a function of coefficients f has the derivative of coefficients Dᵀ f.
pub const fn derivative<const N: usize>() -> [[f64; N]; N] {
    let mut matrix = [[0.0; N]; N];
    let mut n = 1;
    while n < N {
        let mut k = (n - 1) % 2;
        while k < n {
            matrix[n][k] = const_sqrt(((2 * n + 1) * (2 * k + 1)) as f64);
            k += 2;
        }
        n += 1;
    }
    matrix
}
