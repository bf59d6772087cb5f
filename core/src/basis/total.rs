//! The square [−1, 1]², all products of total degree ≤ N.
//!
//! ```text
//! φ_k(s, t) = p_i(s) p_j(t),   i + j ≤ N,   p_n = √(n + ½) P_n,   ∬ φ_k φ_l ds dt = δ_kl
//! ```
//!
//! Order: total degree d = i + j ascending, within d: j ascending, i = d − j. Hence k = d (d + 1)/2 + j, and
//! the functions of a lower order are the first ones of a higher.

use crate::legendre;

/// The largest order of the bases on the square.
pub const LARGEST: usize = 63;

/// p_0 … p_63 at one coordinate; only the first entries are filled.
type Row = [f64; LARGEST + 1];

/// The number of products of total degree ≤ `order`: (N + 1)(N + 2)/2.
pub const fn count(order: usize) -> usize {
    (order + 1) * (order + 2) / 2
}

/// The position k of p_i(s) p_j(t).
pub const fn index(i: usize, j: usize) -> usize {
    let degree = i + j;
    degree * (degree + 1) / 2 + j
}

/// The degrees (i, j) of the function at position k: the inverse of [`index`].
pub const fn degrees(k: usize) -> (usize, usize) {
    let degree = ((8 * k + 1).isqrt() - 1) / 2;
    let j = k - degree * (degree + 1) / 2;
    (degree - j, j)
}

/// Writes φ_k(s, t), k = 0 … [`count`]`(order)` − 1, for (s, t) ∈ [−1, 1]².
///
/// # Panics
/// If `out.len() != count(order)` or `order > `[`LARGEST`].
pub fn values(order: usize, s: f64, t: f64, out: &mut [f64]) {
    check(order, out.len());
    let [p, q] = factors(order, s, t);
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
    let [[p, dp], [q, dq]] = factors_with_derivatives(order, s, t);
    products(order, &p, &q, out);
    products(order, &dp, &q, by_s);
    products(order, &p, &dq, by_t);
}

/// `out[k][l]` = `φ_k(s[l], t[l])` for the order P − 1, W = 8 or 16 points side by side.
///
/// # Panics
/// If `out.len() != count(P − 1)`.
#[inline]
pub fn tile<const P: usize, const W: usize>(s: &[f64; W], t: &[f64; W], out: &mut [[f64; W]]) {
    assert_eq!(out.len(), P * (P + 1) / 2, "one row per function of total degree < {P}");
    let (mut p, mut q) = ([[0.0; W]; P], [[0.0; W]; P]);
    legendre::tile(s, &mut p);
    legendre::tile(t, &mut q);
    let mut rows = out.iter_mut();
    for degree in 0..P {
        for (j, row) in rows.by_ref().take(degree + 1).enumerate() {
            for l in 0..W {
                row[l] = p[degree - j][l] * q[j][l];
            }
        }
    }
}

fn check(order: usize, length: usize) {
    assert!(order <= LARGEST, "total degree {order} is above {LARGEST}");
    assert_eq!(length, count(order), "one entry per function of total degree ≤ {order}");
}

/// `out[k]` = p_i q_j.
fn products(order: usize, p: &Row, q: &Row, out: &mut [f64]) {
    for degree in 0..=order {
        for j in 0..=degree {
            out[index(degree - j, j)] = p[degree - j] * q[j];
        }
    }
}

/// p_i(s) and p_j(t) for i, j ≤ `order`.
fn factors(order: usize, s: f64, t: f64) -> [Row; 2] {
    [s, t].map(|x| {
        let mut p = [0.0; LARGEST + 1];
        legendre::orthonormal(x, &mut p[..=order]);
        p
    })
}

/// [p_i(s), p_i′(s)] and [p_j(t), p_j′(t)] for i, j ≤ `order`.
fn factors_with_derivatives(order: usize, s: f64, t: f64) -> [[Row; 2]; 2] {
    [s, t].map(|x| {
        let (mut p, mut d) = ([0.0; LARGEST + 1], [0.0; LARGEST + 1]);
        legendre::orthonormal_with_derivatives(x, &mut p[..=order], &mut d[..=order]);
        [p, d]
    })
}
