//! Solving with the factors of a matrix.

/// A matrix in factors.
pub(crate) trait Factors: Send + Sync {
    /// x := A⁻¹ x for each of the columns of x, which lie one after the other.
    fn solve(&self, x: &mut [f64]);

    /// x := A⁻ᵀ x.
    fn solve_transposed(&self, x: &mut [f64]);
}
