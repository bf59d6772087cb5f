//! The transfer matrix G as checks use it, whatever carries light between elements: its products, and which
//! rows are complete.

use radiosity_kernel::Blocks;

/// A transfer matrix G in any form.
pub trait Carrier: Sync {
    /// The first coefficient of each element, and the dimension at the end.
    fn starts(&self) -> &[usize];

    /// y = G x.
    fn apply(&self, x: &[f64]) -> Vec<f64>;

    /// y = Gᵀ x.
    fn apply_transposed(&self, x: &[f64]) -> Vec<f64>;

    /// G c for the coefficients c of the constant 1, before any correction.
    fn integrated_constant(&self, ones: &[f64]) -> Vec<f64>;

    /// Whether rays found what G is, so that it is noisy.
    fn is_noisy(&self) -> bool;

    /// Whether an element's row is known as a whole.
    fn is_complete(&self, element: usize) -> bool;
}

impl Carrier for Blocks {
    fn starts(&self) -> &[usize] {
        self.starts()
    }

    fn apply(&self, x: &[f64]) -> Vec<f64> {
        self.apply(x)
    }

    fn apply_transposed(&self, x: &[f64]) -> Vec<f64> {
        self.apply_transposed(x)
    }

    fn integrated_constant(&self, ones: &[f64]) -> Vec<f64> {
        self.integrated_constant(ones)
    }

    fn is_noisy(&self) -> bool {
        self.is_by_rays()
    }

    fn is_complete(&self, element: usize) -> bool {
        self.is_complete(element)
    }
}
