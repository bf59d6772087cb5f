//! Which polynomials an element of order N carries.
//!
//! | | monomials a^i b^j | count | levels of the recurrence |
//! | --- | --- | --- | --- |
//! | total | i + j ≤ N | (N + 1)(N + 2)/2 | i + j = d, from d (d + 1)/2 |
//! | tensor | i, j ≤ N | (N + 1)² | max(i, j) = d, from d² |
//!
//! The first space does not depend on the affine coordinates (a, b), the second does.

use radiosity_core::basis::{tensor, total};
use serde::{Deserialize, Serialize};

use super::patch::Patch;
use super::recurrence::Levels;

/// Total degree ≤ N, or degree ≤ N in each coordinate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Space {
    /// i + j ≤ N; products in the order of `radiosity_core::basis::total`.
    #[default]
    Total,
    /// i, j ≤ N; products in the order of `radiosity_core::basis::tensor`.
    Tensor,
}

impl Space {
    /// Number of functions at order `order`.
    pub const fn count(self, order: usize) -> usize {
        match self {
            Self::Total => total::count(order),
            Self::Tensor => tensor::count(order),
        }
    }

    /// Degrees (i, j) of the product at position k.
    pub fn degrees(self, order: usize, k: usize) -> (usize, usize) {
        match self {
            Self::Total => total::degrees(k),
            Self::Tensor => tensor::degrees(order, k),
        }
    }

    /// Highest total degree of a function.
    pub(crate) const fn total_degree(self, order: usize) -> usize {
        match self {
            Self::Total => order,
            Self::Tensor => 2 * order,
        }
    }

    /// Highest degree of a function along one direction of the charts of `patches`: charts of curved elements
    /// run along the coordinates, charts of flat ones may run in any direction.
    pub fn chart_degree(self, order: usize, patches: &[Patch]) -> usize {
        if patches.iter().all(Patch::is_flat) { self.total_degree(order) } else { order }
    }

    /// The levels of the recurrence up to order `order`.
    pub(crate) fn levels(self, order: usize) -> Levels {
        let start = |level: usize| match self {
            Self::Total => level * (level + 1) / 2,
            Self::Tensor => level * level,
        };
        let first: &[[i32; 2]] = match self {
            Self::Total => &[[1, 0], [0, 1]],
            Self::Tensor => &[[1, 0], [0, 1], [1, 1]],
        };
        Levels {
            functions: (0..=order).map(|level| start(level)..start(level + 1)).collect(),
            first: first.to_vec(),
        }
    }
}
