//! Solving with the factors of a matrix.

/// A matrix in factors.
pub(crate) trait Factors: Send + Sync {
    /// x := A⁻¹ x.
    fn solve(&self, x: &mut [f64]);

    /// x := A⁻ᵀ x.
    fn solve_transposed(&self, x: &mut [f64]);
}
