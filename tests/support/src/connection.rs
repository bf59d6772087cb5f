//! Connection coefficients of orthonormal Jacobi and Legendre polynomials in fixed point with 320 binary
//! digits.
//!
//! Independent of the crate: the textbook step of one exponent by one (NIST Digital Library of Mathematical
//! Functions, 18.9.5) in the classical polynomials, all steps of β and then all of α, and norms from their
//! definition. The steps cancel, by 27 decimal digits at (20, 20), n = 100; ninety-six are carried.

use crate::oracle::Fixed;

/// d = A c between the systems of the weights (1 − x)^a (1 + x)^b and 1.
#[derive(Clone, Copy, Debug)]
pub struct Connection {
    a: usize,
    b: usize,
}

impl Connection {
    /// The connection of the weight (1 − x)^a (1 + x)^b with the weight 1.
    pub fn new(a: u8, b: u8) -> Connection {
        Connection { a: a.into(), b: b.into() }
    }

    /// A c: Jacobi coefficients → Legendre coefficients.
    pub fn apply(self, c: &[Fixed]) -> Vec<Fixed> {
        let mut c: Vec<Fixed> = c.iter().enumerate().map(|(n, c)| c / &norm(self.a, self.b, n)).collect();
        for beta in (0..self.b).rev() {
            lower(&mut c, self.a + beta, self.a, -1);
        }
        for alpha in (0..self.a).rev() {
            lower(&mut c, alpha, 0, 1);
        }
        c.iter().enumerate().map(|(n, c)| c * &norm(0, 0, n)).collect()
    }

    /// A⁻¹ d: Legendre coefficients → Jacobi coefficients.
    pub fn apply_inverse(self, d: &[Fixed]) -> Vec<Fixed> {
        let mut d: Vec<Fixed> = d.iter().enumerate().map(|(n, d)| d / &norm(0, 0, n)).collect();
        for alpha in 0..self.a {
            raise(&mut d, alpha, 0, -1);
        }
        for beta in 0..self.b {
            raise(&mut d, self.a + beta, self.a, 1);
        }
        d.iter().enumerate().map(|(n, d)| d * &norm(self.a, self.b, n)).collect()
    }

    /// |A| |c|, since A_kn has the sign of column n by that of row k.
    pub fn size(self, c: &[Fixed]) -> Vec<Fixed> {
        let turned: Vec<Fixed> = c.iter().enumerate().map(|(n, c)| c.abs().times(self.sign(n), 1)).collect();
        self.apply(&turned).iter().map(Fixed::abs).collect()
    }

    /// |A⁻¹| |d|, since entries of A⁻¹ have the sign of the column by that of the row, where they have one.
    pub fn inverse_size(self, d: &[Fixed]) -> Option<Vec<Fixed>> {
        let turned: Option<Vec<Fixed>> =
            d.iter().enumerate().map(|(n, d)| Some(d.abs().times(self.inverse_sign(n)?, 1))).collect();
        Some(self.apply_inverse(&turned?).iter().map(Fixed::abs).collect())
    }

    /// The sign of row or column n of A: 1 for a ≥ b, else (−1)ⁿ.
    pub fn sign(self, n: usize) -> i64 {
        if self.a < self.b { alternating(n) } else { 1 }
    }

    /// The sign of row or column n of A⁻¹, if a = b or one of them is 0; else the signs are mixed.
    pub fn inverse_sign(self, n: usize) -> Option<i64> {
        match (self.a, self.b) {
            (0, _) => Some(1),
            (_, 0) => Some(alternating(n)),
            (a, b) if a == b => Some(alternating(n / 2)),
            _ => None,
        }
    }
}

/// ‖P_n^(a,b)‖ = √(2^{a+b+1}/(2n + a + b + 1) · Π_{j=1…b} (n + j)/(n + a + j)).
pub fn norm(a: usize, b: usize, n: usize) -> Fixed {
    let [a, b, n] = [a, b, n].map(|v| v as i64);
    let power = (0..a + b).fold(Fixed::new(2), |power, _| power.times(2, 1));
    let start = power.times(1, 2 * n + a + b + 1);
    (1..=b).fold(start, |square, j| square.times(n + j, n + a + j)).sqrt()
}

/// Coefficients for an exponent that is one less: `sum` is α + β after the step, `other` the exponent that
/// stays, `sign` −1 for β and +1 for α.
fn lower(c: &mut [Fixed], sum: usize, other: usize, sign: i64) {
    let (sum, other) = (sum as i64, other as i64);
    let mut above = Fixed::new(0);
    for (n, c) in c.iter_mut().enumerate().rev() {
        let n = n as i64;
        let carried = above.times(sign * (n + 1 + other), 2 * n + sum + 3);
        above = (c.clone() + carried).times(2 * n + sum + 1, n + sum + 1);
        *c = above.clone();
    }
}

/// Coefficients for an exponent that is one more: `sum` is α + β before the step, `other` the exponent that
/// stays, `sign` +1 for β and −1 for α.
fn raise(d: &mut [Fixed], sum: usize, other: usize, sign: i64) {
    let (sum, other) = (sum as i64, other as i64);
    let mut above = Fixed::new(0);
    for (n, d) in d.iter_mut().enumerate().rev() {
        let n = n as i64;
        let carried = above.times(sign * (n + 1 + other), 2 * n + sum + 3);
        above = d.clone();
        *d = d.times(n + sum + 1, 2 * n + sum + 1) + carried;
    }
}

fn alternating(n: usize) -> i64 {
    if n.is_multiple_of(2) { 1 } else { -1 }
}
