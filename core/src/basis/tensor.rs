//! The square [−1, 1]², all products of degree ≤ N in each variable.
//!
//! ```text
//! φ_k(s, t) = p_i(s) p_j(t),   i, j ≤ N,   k = i (N + 1) + j,   ∬ φ_k φ_l ds dt = δ_kl
//! ```

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
