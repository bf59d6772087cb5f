//! The connection matrix p_n^(α,β) = Σ_k C[n][k] p_k.

use super::squared_norm;
use crate::double::Double;

/// The exact lower triangular matrix C of p_n^(α,β) = Σ_{k≤n} `C[n][k]` p_k, n < N, entries correctly rounded.
///
/// ```
/// use radiosity_core::convert::Connection;
///
/// const C: Connection<3> = Connection::new(0, 2);
/// // p_0 of the weight (1 + x)² is √(3/8) = √(3/4) p_0.
/// assert_eq!(C.matrix()[0], [0.75f64.sqrt(), 0.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Connection<const N: usize> {
    matrix: [[f64; N]; N],
}

impl<const N: usize> Connection<N> {
    /// The matrix of the weight (1 − x)^a (1 + x)^b.
    pub const fn new(a: u8, b: u8) -> Connection<N> {
        let mut matrix = [[0.0; N]; N];
        let mut n = 0;
        while n < N {
            let mut row = [Double::ZERO; N];
            row[n] = Double::ONE;
            lower(&mut row, n, a, b);
            let jacobi = squared_norm(a, b, n);
            let mut k = 0;
            while k <= n {
                // Equal exponents keep the parity: the other entries are zero, which the steps only approach.
                if a != b || (n - k).is_multiple_of(2) {
                    matrix[n][k] = row[k].mul(squared_norm(0, 0, k).div(jacobi).sqrt()).hi;
                }
                k += 1;
            }
            n += 1;
        }
        Connection { matrix }
    }

    /// `C[n][k]`.
    pub const fn matrix(&self) -> &[[f64; N]; N] {
        &self.matrix
    }

    /// Jacobi coefficients → Legendre coefficients of the same function: d_k = Σ_n `C[n][k]` c_n.
    pub fn to_legendre(&self, jacobi: &[f64; N]) -> [f64; N] {
        let mut out = [0.0; N];
        for (row, c) in self.matrix.iter().zip(jacobi) {
            for (d, entry) in out.iter_mut().zip(row) {
                *d += c * entry;
            }
        }
        out
    }
}

/// Classical coefficients up to degree n for (a, b) → those for (0, 0): first β, then α, a unit at a time.
const fn lower<const N: usize>(row: &mut [Double; N], n: usize, a: u8, b: u8) {
    let (mut alpha, mut beta) = (a as usize, b as usize);
    while beta > 0 {
        beta -= 1;
        unit(row, n, alpha + beta, alpha, -1.0);
    }
    while alpha > 0 {
        alpha -= 1;
        unit(row, n, alpha, 0, 1.0);
    }
}

/// Solves for the coefficients with one unit less, given the sum of the exponents after it and the other exponent.
const fn unit<const N: usize>(row: &mut [Double; N], n: usize, sum: usize, other: usize, sign: f64) {
    let mut above = Double::ZERO;
    let mut k = n + 1;
    while k > 0 {
        k -= 1;
        let back = Double::ratio(sign * (k + 1 + other) as f64, (2 * k + sum + 3) as f64);
        let factor = Double::ratio((2 * k + sum + 1) as f64, (k + sum + 1) as f64);
        above = row[k].add(above.mul(back)).mul(factor);
        row[k] = above;
    }
}
