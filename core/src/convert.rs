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
//! which multiplies forwards (Legendre to Jacobi) and is solved downwards (Jacobi to Legendre): O(n) per unit of α or
//! β, in place ([`to_legendre`], [`from_legendre`]). [`Connection`] holds the whole matrix, made from the same steps in
//! double-double and rounded once: exact entries, O(n²) to apply. It is the better choice where both α, β > 0: there
//! the steps lose a digit for (2, 2) by n = 30, five for (10, 10), and all in the end. Converting through powers of x,
//! as Zatz (1993) suggests, loses nine.
//!
//! ```text
//! ‖P_n^(α,β)‖² = 2^(α+β+1)/(2n + α + β + 1) · Π_{j=1…β} (n + j)/(n + α + j)
//! ```
//!
//! Reference: NIST Digital Library of Mathematical Functions, 18.9.5 and table 18.3.1.

mod connection;
mod steps;

pub use self::connection::Connection;
pub use self::steps::{from_legendre, to_legendre};

use crate::double::Double;

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
