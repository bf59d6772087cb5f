//! Conversion in place, one unit of an exponent at a time.

use super::squared_norm;
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
