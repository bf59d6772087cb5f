//! The factors p_i(s) and p_j(t) of products on the square.

use crate::legendre;

/// The largest order of the bases on the square: the length of the arrays below, minus 1.
pub const LARGEST: usize = 63;

/// p_0 … p_63 at one coordinate; only the first entries are filled.
pub(super) type Row = [f64; LARGEST + 1];

/// p_i(s) and p_j(t) for i, j ≤ `order`.
///
/// # Panics
/// If `order > `[`LARGEST`].
pub(super) fn values(order: usize, s: f64, t: f64) -> [Row; 2] {
    [s, t].map(|x| {
        let mut p = [0.0; LARGEST + 1];
        legendre::orthonormal(x, &mut p[..=order]);
        p
    })
}

/// [p_i(s), p_i′(s)] and [p_j(t), p_j′(t)] for i, j ≤ `order`.
///
/// # Panics
/// If `order > `[`LARGEST`].
pub(super) fn derivatives(order: usize, s: f64, t: f64) -> [[Row; 2]; 2] {
    [s, t].map(|x| {
        let (mut p, mut d) = ([0.0; LARGEST + 1], [0.0; LARGEST + 1]);
        legendre::orthonormal_with_derivatives(x, &mut p[..=order], &mut d[..=order]);
        [p, d]
    })
}
