//! The square [−1, 1]², all products of total degree ≤ N.
//!
//!   φ_k(s, t) = p_i(s) p_j(t),   i + j ≤ N,   p_n = √(n + ½) P_n,   ∬ φ_k φ_l ds dt = δ_kl
//!
//! Order: total degree d = i + j ascending, within d: j ascending, i = d − j. Hence k = d (d + 1)/2 + j.

use crate::legendre;

/// The largest order that [`values`] accepts.
pub const LARGEST: usize = 63;

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

/// Writes all φ_k(s, t), k = 0 … [`count`]`(order)` − 1, for (s, t) ∈ [−1, 1]².
///
/// # Panics
/// If `out.len() != count(order)` or `order > `[`LARGEST`].
pub fn values(order: usize, s: f64, t: f64, out: &mut [f64]) {
    assert!(order <= LARGEST, "total degree {order} is above {LARGEST}");
    assert_eq!(out.len(), count(order), "one value per function of total degree ≤ {order}");
    let (mut p, mut q) = ([0.0; LARGEST + 1], [0.0; LARGEST + 1]);
    legendre::orthonormal(s, &mut p[..=order]);
    legendre::orthonormal(t, &mut q[..=order]);
    for degree in 0..=order {
        for j in 0..=degree {
            out[index(degree - j, j)] = p[degree - j] * q[j];
        }
    }
}
