//! An element as a single parametric patch, which the paper's rules need, and conversion of K to G.
//!
//! φ = T L, with L the parameter-orthonormal polynomials and T lower triangular. A function Σ_l b_l φ_l has
//! the parameter coefficients Tᵀ b, so K, which maps parameter coefficients to parameter coefficients,
//! becomes
//!
//! ```text
//! G = T_i^−ᵀ K T_jᵀ .
//! ```
//!
//! On a parallelogram T = (2/√A) I and G = √(A_i/A_j) K. On a receiver whose area element varies the paper
//! projects in the parameters, so that even exact integrals give another G than projection with respect to
//! area.

use nalgebra::DMatrix;
use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_geom::COINCIDENT;

use crate::zatz1993::transfers::charted_element::ChartedElement;

/// A surface that is not a single parametric patch: a polygon other than a parallelogram, or one with holes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("surface {surface} is neither a parallelogram nor curved")]
pub struct NoChart {
    /// Index of the surface in the scene.
    pub surface: usize,
}

/// An element that is a single parametric patch: a parallelogram, or a piece of a curved surface.
#[derive(Clone, Debug)]
pub(super) struct Chart<'a> {
    /// The element.
    pub element: &'a Element,
    patch: Patch,
}

impl<'a> Chart<'a> {
    /// The chart of `element`.
    ///
    /// # Errors
    /// [`NoChart`].
    pub(super) fn of(element: &'a Element) -> Result<Self, NoChart> {
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
            |x: f64, y: f64| places.iter().position(|[a, b]| (a - x).abs().max((b - y).abs()) <= COINCIDENT);
        let (first, second) = (corner(-1.0, -1.0)?, corner(1.0, -1.0)?);
        Some(patch.oriented(first, second))
    }

    /// The element with `extra` points per direction above its order.
    pub(super) fn charted(&self, extra: usize) -> ChartedElement<'_> {
        let order = self.element.basis.order();
        ChartedElement { patch: &self.patch, order, points: order + extra }
    }

    /// G, row-major, from K, row-major, both with this element as receiver.
    pub(super) fn block(&self, emitter: &Self, transfer: &[f64]) -> Vec<f64> {
        let [own, other] = [self, emitter].map(|chart| {
            let basis = &chart.element.basis;
            DMatrix::from_row_slice(basis.len(), basis.len(), basis.transform())
        });
        let transfer = DMatrix::from_row_slice(own.nrows(), other.nrows(), transfer);
        let block = own.tr_solve_lower_triangular(&(transfer * other.transpose()));
        block.expect("the functions of a basis are independent").transpose().as_slice().to_vec()
    }
}

#[cfg(test)]
mod tests {
    use radiosity_core::{dot, norm};
    use radiosity_elements::columns::transposed;
    use radiosity_elements::{Discretization, Elements};

    use super::*;

    /// T_iᵀ G = K T_jᵀ, of polynomials that mix on curved surfaces; on parallelograms G = √(A_i/A_j) K.
    #[test]
    fn blocks_are_transfers_in_orthonormal_functions() {
        let surfaces = "
            [[surfaces]]\nname = 'ball'\nsphere = { center = [0, 0, 9], radius = 1 }
            [[surfaces]]\nname = 'disk'\ndisk = { center = [5, 0, 0], normal = [0, 0, 1], radius = 0.5 }
            [[surfaces]]\nname = 'quad'\nquad = { vertices = [[0, 0, 5], [2, 0, 5], [3, 2, 5], [1, 2, 5]] }";
        let scene =
            radiosity_language::read(&radiosity_scene::Source::new("scene", surfaces)).expect("it is valid");
        let elements = Elements::new(&scene, &Discretization::uniform(3, 1)).expect("all have area");
        let charts: Vec<Chart> =
            elements.list().iter().map(|element| Chart::of(element).expect("one patch")).collect();
        assert_eq!(charts.len(), 3);
        for (receiver, emitter) in charts.iter().flat_map(|a| charts.iter().map(move |b| (a, b))) {
            let [own, other] = [receiver, emitter].map(|chart| &chart.element.basis);
            let transfer: Vec<f64> =
                (0..own.len() * other.len()).map(|k| (k as f64 * 0.7).sin() / (1.0 + k as f64)).collect();
            let block = receiver.block(emitter, &transfer);
            let (of_block, of_own) =
                (transposed(&block, other.len()), transposed(own.transform(), own.len()));
            for k in 0..own.len() {
                for l in 0..other.len() {
                    let left =
                        dot(&of_own[k * own.len()..][..own.len()], &of_block[l * own.len()..][..own.len()]);
                    let rows = [&transfer[k * other.len()..], &other.transform()[l * other.len()..]];
                    let right = dot(&rows[0][..other.len()], &rows[1][..other.len()]);
                    assert!(
                        (left - right).abs() < 1e-13 * norm(other.transform()),
                        "{k} {l}: {left} {right}"
                    );
                }
            }
        }
        let quad = &charts[2];
        let transfer = vec![0.25; quad.element.basis.len().pow(2)];
        let same = quad.block(quad, &transfer);
        assert!(same.iter().all(|g| (g - 0.25).abs() < 1e-14), "{same:?}");
    }
}
