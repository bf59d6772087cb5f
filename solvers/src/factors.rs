//! What a factorisation is good for.

/// A matrix in factors.
pub(crate) trait Factors {
    /// x := A⁻¹ x.
    fn solve(&self, x: &mut [f64]);

    /// x := A⁻ᵀ x.
    fn solve_transposed(&self, x: &mut [f64]);
}
