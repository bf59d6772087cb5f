//! The transfer matrix G as checks use it, whatever carries light between elements: its products, and which
//! rows are complete.

use std::collections::BTreeMap;

use radiosity_elements::Element;
use radiosity_kernel::{Blocks, PlacedBlock};

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

    /// Largest |A_i F_ij − A_j F_ji| / min(A_i, A_j) that is known.
    fn reciprocity(&self, list: &[Element]) -> f64;
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

    /// A_i F_ij = ∫ φ_0 dA_i G_ij^00 ∫ φ_0 dA_j; the other φ_k have no mean.
    fn reciprocity(&self, list: &[Element]) -> f64 {
        if self.symmetric() {
            return self.statistics.reciprocity.largest;
        }
        let exchanged = |PlacedBlock { row: i, column: j, values }: PlacedBlock<'_>| {
            ((i, j), list[i].constant[0] * values[0] * list[j].constant[0])
        };
        let exchanged: BTreeMap<(usize, usize), f64> = self.gathered().iter().map(exchanged).collect();
        let difference = |((i, j), there): (&(usize, usize), &f64)| {
            let back = exchanged.get(&(*j, *i)).copied().unwrap_or_default();
            (there - back).abs() / list[*i].area.min(list[*j].area)
        };
        exchanged.iter().map(difference).fold(0.0, f64::max)
    }
}
