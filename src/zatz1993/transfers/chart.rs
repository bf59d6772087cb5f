//! An element as a single parametric patch, which the paper's rules need, and conversion of K to G.
//!
//! φ = T L, with L the parameter-orthonormal polynomials and T lower triangular. A function Σ_l b_l φ_l has the
//! parameter coefficients Tᵀ b, so K, which maps parameter coefficients to parameter coefficients, becomes
//!
//! ```text
//! G = T_i^−ᵀ K T_jᵀ .
//! ```
//!
//! On a parallelogram T = (2/√A) I and G = √(A_i/A_j) K. On a receiver whose area element varies the paper projects in
//! the parameters, so that even exact integrals give another G than projection with respect to area.

use crate::elements::Element;
use crate::elements::patch::Patch;
use crate::zatz1993::transfers::party::Party;

/// How far coordinates of corners may be from ±1. Chosen; not tuned.
const TOLERANCE: f64 = 1e-9;

/// A surface that is not a single parametric patch: a polygon other than a parallelogram, or one with holes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("surface {surface} is neither a parallelogram nor curved")]
pub struct NoChart {
    /// Index of the surface in the scene.
    pub surface: usize,
}

/// An element that is a single parametric patch: a parallelogram, or a piece of a curved surface.
#[derive(Clone, Debug)]
pub struct Chart<'a> {
    /// The element.
    pub element: &'a Element,
    patch: Patch,
}

impl<'a> Chart<'a> {
    /// The chart of `element`.
    ///
    /// # Errors
    /// [`NoChart`].
    pub fn of(element: &'a Element) -> Result<Self, NoChart> {
        Self::patch(element).map(|patch| Self { element, patch }).ok_or(NoChart { surface: element.surface })
    }

    /// The patch whose chart [0, 1]² runs along the element's coordinates [−1, 1]².
    fn patch(element: &Element) -> Option<Patch> {
        let [patch] = element.patches.as_slice() else { return None };
        if patch.is_flat() && !patch.is_parallelogram() {
            return None;
        }
        let frame = element.basis.frame();
        let places = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(s, t)| frame.coordinates(&patch.node(s, t)));
        let corner =
            |x: f64, y: f64| places.iter().position(|[a, b]| (a - x).abs().max((b - y).abs()) <= TOLERANCE);
        let (first, second) = (corner(-1.0, -1.0)?, corner(1.0, -1.0)?);
        Some(patch.oriented(first, second))
    }

    /// The element with `extra` points per direction above its order.
    pub fn party(&self, extra: usize) -> Party<'_> {
        let order = self.element.basis.order();
        Party { patch: &self.patch, order, points: order + extra }
    }

    /// G, row-major, from K, row-major, both with this element as receiver.
    pub fn block(&self, emitter: &Self, transfer: &[f64]) -> Vec<f64> {
        let columns = emitter.element.basis.len();
        let transforms = emitter.element.basis.transform();
        // K T_jᵀ, row by row.
        let mut block: Vec<f64> = transfer
            .chunks_exact(columns)
            .flat_map(|row| transforms.chunks_exact(columns).map(move |line| dot(row, line)))
            .collect();
        self.solve_transposed(&mut block, columns);
        block
    }

    /// Overwrites X with T^−ᵀ X.
    fn solve_transposed(&self, x: &mut [f64], columns: usize) {
        let (count, transform) = (self.element.basis.len(), self.element.basis.transform());
        for k in (0..count).rev() {
            let (above, below) = x.split_at_mut((k + 1) * columns);
            let row = &mut above[k * columns..];
            for (m, later) in below.chunks_exact(columns).enumerate() {
                let factor = transform[(k + 1 + m) * count + k];
                row.iter_mut().zip(later).for_each(|(r, x)| *r -= factor * x);
            }
            row.iter_mut().for_each(|r| *r /= transform[k * count + k]);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
