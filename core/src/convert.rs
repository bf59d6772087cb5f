//! From orthonormal Jacobi to orthonormal Legendre coefficients and back, integer exponents.
//!
//! ```text
//! Σ_n c_n p_n^(α,β) = Σ_k d_k p_k
//! ```
//!
//! Both ways rest on one step between neighbouring exponents in the classical polynomials,
//!
//! ```text
//! (2n + α + β + 1) P_n^(α,β) = (n + α + β + 1) P_n^(α,β+1) + (n + α) P_{n−1}^(α,β+1)
//! (2n + α + β + 1) P_n^(α,β) = (n + α + β + 1) P_n^(α+1,β) − (n + β) P_{n−1}^(α+1,β)
//! ```
//!
//! which multiplies forwards (Legendre to Jacobi) and is solved downwards (Jacobi to Legendre): O(n) per unit of α or β,
//! in place. The steps lose a digit for (2, 2) by n = 30, five for (10, 10); for α = 0 or β = 0 they lose none. Converting
//! through powers of x, as Zatz (1993) suggests, loses nine.
//!
//! ```text
//! ‖P_n^(α,β)‖² = 2^(α+β+1)/(2n + α + β + 1) · Π_{j=1…β} (n + j)/(n + α + j)
//! ```
//!
//! Reference: NIST Digital Library of Mathematical Functions, 18.9.5 and table 18.3.1.

use crate::double::Double;
use crate::math::sqrt;

/// Orthonormal Jacobi coefficients of the weight (1 − x)^a (1 + x)^b → orthonormal Legendre coefficients, in place.
pub fn to_legendre(a: u8, b: u8, coefficients: &mut [f64]) {
    for (n, c) in coefficients.iter_mut().enumerate() {
        *c /= sqrt(squared_norm(a, b, n).hi);
    }
    for beta in (0..b as usize).rev() {
        solve(coefficients, a as usize + beta, a as usize, -1.0);
    }
    for alpha in (0..a as usize).rev() {
        solve(coefficients, alpha, 0, 1.0);
    }
    for (n, c) in coefficients.iter_mut().enumerate() {
        *c *= sqrt(squared_norm(0, 0, n).hi);
    }
}

/// Orthonormal Legendre coefficients → orthonormal Jacobi coefficients of the weight (1 − x)^a (1 + x)^b, in place.
pub fn from_legendre(a: u8, b: u8, coefficients: &mut [f64]) {
    for (n, c) in coefficients.iter_mut().enumerate() {
        *c /= sqrt(squared_norm(0, 0, n).hi);
    }
    for alpha in 0..a as usize {
        multiply(coefficients, alpha, 0, -1.0);
    }
    for beta in 0..b as usize {
        multiply(coefficients, a as usize + beta, a as usize, 1.0);
    }
    for (n, c) in coefficients.iter_mut().enumerate() {
        *c *= sqrt(squared_norm(a, b, n).hi);
    }
}

/// ‖P_n^(a,b)‖².
const fn squared_norm(a: u8, b: u8, n: usize) -> Double {
    let mut norm = Double::ratio(2.0, (2 * n + a as usize + b as usize + 1) as f64);
    let mut j = 1;
    while j <= a as usize + b as usize {
        norm = norm.scale(2.0);
        if j <= b as usize {
            norm = norm.mul(Double::ratio((n + j) as f64, (n + a as usize + j) as f64));
        }
        j += 1;
    }
    norm
}

/// One unit down: `sum` is α + β after it, `other` the exponent that stays, `sign` −1 for β and +1 for α.
fn solve(coefficients: &mut [f64], sum: usize, other: usize, sign: f64) {
    let mut above = 0.0;
    for (n, c) in coefficients.iter_mut().enumerate().rev() {
        let back = sign * (n + 1 + other) as f64 / (2 * n + sum + 3) as f64;
        above = (*c + above * back) * (2 * n + sum + 1) as f64 / (n + sum + 1) as f64;
        *c = above;
    }
}

/// One unit up: `sum` is α + β before it, `other` the exponent that stays, `sign` +1 for β and −1 for α.
fn multiply(coefficients: &mut [f64], sum: usize, other: usize, sign: f64) {
    for n in 0..coefficients.len() {
        let above = coefficients.get(n + 1).copied().unwrap_or(0.0);
        let own = coefficients[n] * (n + sum + 1) as f64 / (2 * n + sum + 1) as f64;
        coefficients[n] = own + sign * above * (n + 1 + other) as f64 / (2 * n + sum + 3) as f64;
    }
}
