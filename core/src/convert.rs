//! From orthonormal Jacobi to orthonormal Legendre coefficients and back, integer exponents a, b ≤ 255.
//!
//! ```text
//! Σ_n c_n p_n^(a,b) = Σ_k d_k p_k,   d = A c
//! ```
//!
//! Steps lead from the exponents (a, b) to (m, m), m = min(a, b), lowering one, and from there to (0, 0),
//! lowering both. With x_n = (min(α, β) + 1)_n/(α + β + 1)_n times the coefficient of the classical
//! P_n^(α,β), every step is a sum and a factor:
//!
//! ```text
//! (α, β) → (α − 1, β)        x_k ← (2k + s)/s · (x_k + x_{k+1} + x_{k+2} + …),     s = α + β
//! (α, β) → (α, β − 1)        x_k ← (2k + s)/s · (x_k − x_{k+1} + x_{k+2} − …),     s = α + β
//! (α, α) → (α − 1, α − 1)    x_k ← (2k + s)/s · (x_k + x_{k+2} + x_{k+4} + …),     s = 2α − 1
//! ```
//!
//! The last is Gegenbauer's C_n^(μ+1) = Σ_j (n − 2j + μ)/μ C_{n−2j}^(μ), as P_n^(α,α) is C_n^(α+½) times
//! (α + 1)_n/(2α + 1)_n. All divisors s, 1/‖P_n^(a,b)‖ and (m + 1)_n/(a + b + 1)_n make one number,
//!
//! ```text
//! D_n² = 2^−|a−b| (n + (a + b + 1)/2) n! (n + m)!/((n + M)! (n + a + b)!),   M = max(a, b),
//! ```
//!
//! carried on from n to n + 1 in two floats. The way back takes differences for sums, in the opposite order.
//! Either way is O(n) for each of M steps, in place, with one rounding for a term and one for a factor.
//!
//! # Accuracy
//!
//! No step cancels: A_kn ≥ 0 for a ≥ b, (−1)^{n−k} A_kn ≥ 0 for a < b. The error of d_k is below
//! 12 ε Σ_n |A_kn c_n| for a, b ≤ 20 and n ≤ 100 (tested; 5 ε seen). For a = b even and odd degrees never
//! meet: what is 0 stays 0.
//!
//! The way back is as good where the entries of A⁻¹ keep their signs, too, that is for a = b, a = 0 or b = 0:
//! the error of c_n is below 12 ε Σ_k |(A⁻¹)_nk d_k| (4 ε seen). For other exponents A⁻¹ itself cancels, and
//! the bound is the largest of these sums, n = 0, 1, …. It magnifies little: ‖c‖₂ ≤ max √((1 − x)^a
//! (1 + x)^b) · ‖d‖₂, the factor being 1 for a = b.
//!
//! But d may be far larger than the c from which it comes. There and back, c returns to within
//! 24 ε |A⁻¹| |A| |c|, whose largest entry for |c_n| ≤ 1 grows like n^M:
//!
//! | n ≤ | (0, 1) | (1, 1) | (2, 2) | (5, 5) | (3, 7) | (10, 10) | (0, 10) | (20, 20) |
//! | --- | --- | --- | --- | --- | --- | --- | --- | --- |
//! | 30 | 32 | 16 | 129 | 1.3e4 | 7.0e5 | 3.1e6 | 7.4e8 | 3.4e9 |
//! | 60 | 62 | 31 | 463 | 2.6e5 | 4.6e7 | 6.7e8 | 2.9e11 | 4.4e13 |
//! | 100 | 101 | 51 | 1230 | 2.7e6 | 1.3e9 | 5.4e10 | 3.2e13 | 1.3e17 |
//!
//! No algorithm avoids this, once d is rounded to floats: from (20, 20), n = 100, there is no way back.
//!
//! # Range
//!
//! Nothing overflows or underflows on the way, for any exponents, while the entries of A stay below 1e294: to
//! n = 1700 for (0, 255), to n = 2500 for (255, 255) (tested).
//!
//! Reference: NIST Digital Library of Mathematical Functions, 18.3, 18.7.1, 18.9.5, 18.9.7.

mod step;
mod scales;

use self::scales::Scales;
use self::step::steps;
use crate::legendre;

/// Orthonormal Jacobi coefficients of (1 − x)^a (1 + x)^b → orthonormal Legendre coefficients, in place.
///
/// `coefficients[n]` is c_n before and d_n after; there may be any number of them.
///
/// ```
/// // p_0 of the weight (1 + x)² is √(3/8), and √(3/8) = √(3/4) · √(1/2).
/// let mut coefficients = [1.0, 0.0, 0.0];
/// radiosity_core::convert::to_legendre(0, 2, &mut coefficients);
/// assert_eq!(coefficients, [0.75f64.sqrt(), 0.0, 0.0]);
/// ```
pub fn to_legendre(a: u8, b: u8, coefficients: &mut [f64]) {
    let mut steps = steps(a, b);
    let Some(last) = steps.next_back() else { return };
    coefficients.iter_mut().zip(Scales::new(a, b)).for_each(|(c, scale)| *c *= scale);
    for step in steps {
        step.sum(coefficients);
        step.multiply(coefficients);
    }
    last.sum(coefficients);
    coefficients.iter_mut().enumerate().for_each(|(k, c)| *c *= end(k));
}

/// Orthonormal Legendre coefficients → orthonormal Jacobi coefficients of (1 − x)^a (1 + x)^b, in place.
///
/// `coefficients[n]` is d_n before and c_n after; there may be any number of them.
pub fn from_legendre(a: u8, b: u8, coefficients: &mut [f64]) {
    let mut steps = steps(a, b);
    let Some(last) = steps.next_back() else { return };
    coefficients.iter_mut().enumerate().for_each(|(k, c)| *c /= end(k));
    last.differences(coefficients);
    for step in steps.rev() {
        step.divide(coefficients);
        step.differences(coefficients);
    }
    coefficients.iter_mut().zip(Scales::new(a, b)).for_each(|(c, scale)| *c /= scale);
}

/// The factor of the last step, (2k + 1)/4, times 1/√(k + ½).
fn end(k: usize) -> f64 {
    0.5 * legendre::end(k)
}
