//! The square [−1, 1]², all products of degree ≤ N in each variable.
//!
//! ```text
//! φ_k(s, t) = p_i(s) p_j(t),   i, j ≤ N,   k = i (N + 1) + j,   ∬ φ_k φ_l ds dt = δ_kl
//! ```

use super::factors::{self, LARGEST, Row};
use crate::legendre;

/// The number of products of degree ≤ `order` in each variable: (N + 1)².
pub const fn count(order: usize) -> usize {
    (order + 1) * (order + 1)
}

/// The position k of p_i(s) p_j(t).
pub const fn index(order: usize, i: usize, j: usize) -> usize {
    i * (order + 1) + j
}

/// The degrees (i, j) of the function at position k: the inverse of [`index`].
pub const fn degrees(order: usize, k: usize) -> (usize, usize) {
    (k / (order + 1), k % (order + 1))
}

/// Writes φ_k(s, t), k = 0 … [`count`]`(order)` − 1, for (s, t) ∈ [−1, 1]².
///
/// # Panics
/// If `out.len() != count(order)` or `order > `[`LARGEST`].
pub fn values(order: usize, s: f64, t: f64, out: &mut [f64]) {
    check(order, out.len());
    let [p, q] = factors::values(order, s, t);
    products(order, &p, &q, out);
}

/// Writes φ_k, ∂φ_k/∂s and ∂φ_k/∂t at (s, t) ∈ [−1, 1]².
///
/// # Panics
/// If a slice does not have [`count`]`(order)` entries or `order > `[`LARGEST`].
pub fn gradients(order: usize, s: f64, t: f64, out: &mut [f64], by_s: &mut [f64], by_t: &mut [f64]) {
    check(order, out.len());
    check(order, by_s.len());
    check(order, by_t.len());
    let [[p, dp], [q, dq]] = factors::derivatives(order, s, t);
    products(order, &p, &q, out);
    products(order, &dp, &q, by_s);
    products(order, &p, &dq, by_t);
}

/// `out[k][l]` = `φ_k(s[l], t[l])` for the order P − 1, W = 8 or 16 points side by side.
///
/// # Panics
/// If `out.len() != P²`.
#[inline]
pub fn tile<const P: usize, const W: usize>(s: &[f64; W], t: &[f64; W], out: &mut [[f64; W]]) {
    assert_eq!(out.len(), P * P, "one row per function of degree < {P} in each variable");
    let (mut p, mut q) = ([[0.0; W]; P], [[0.0; W]; P]);
    legendre::tile(s, &mut p);
    legendre::tile(t, &mut q);
    for (k, row) in out.iter_mut().enumerate() {
        for l in 0..W {
            row[l] = p[k / P][l] * q[k % P][l];
        }
    }
}

fn check(order: usize, length: usize) {
    assert!(order <= LARGEST, "degree {order} is above {LARGEST}");
    assert_eq!(length, count(order), "one entry per function of degree ≤ {order} in each variable");
}

/// `out[k]` = p_i q_j.
fn products(order: usize, p: &Row, q: &Row, out: &mut [f64]) {
    for (k, value) in out.iter_mut().enumerate() {
        let (i, j) = degrees(order, k);
        *value = p[i] * q[j];
    }
}
