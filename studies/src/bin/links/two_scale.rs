//! The two-scale matrix of an element and a part of it, for the area-orthonormal polynomials of both.
//!
//! ```text
//! H_mk = ∫_child φ_m^child φ_k^parent dA ,     push: b^child = H b^parent ,     pull: b^parent = Σ_children Hᵀ b^child
//! ```
//!
//! Push restricts the parent's polynomial to the child, without error where the child carries polynomials of
//! at least the parent's order in coordinates that are affine in the parent's. Pull is its transpose and the
//! L₂ projection on the parent's polynomials. Where the children cover the parent, Σ HᵀH = 1: pull undoes
//! push, and push keeps ‖b‖₂² = ∫ B² dA (Parseval). The measure of the child integrates the products exactly,
//! so that H is exact up to rounding. On a parallelogram with quarters as children H is the product of the
//! matrices of [`radiosity_core::legendre`] and of ½, from √(A_child/A_parent).
//!
//! Reference: S. Gortler, P. Schröder, M. Cohen, P. Hanrahan, *Wavelet radiosity*, SIGGRAPH 93 (1993), §4.

use radiosity::elements::Element;
use radiosity::elements::measure::{Measure, WeightedNode};
use radiosity::elements::patch::Node;
use radiosity_core::dot;

/// H of one child.
#[derive(Clone, Debug)]
pub(crate) struct TwoScale {
    parent: usize,
    /// H_mk, row by row.
    values: Vec<f64>,
}

impl TwoScale {
    /// H of two elements of one surface, the child a part of the parent.
    pub(crate) fn new(parent: &Element, child: &Element) -> Self {
        let order = parent.basis.order().max(child.basis.order());
        let measure = Measure::new(&child.patches, child.basis.space().chart_degree(order, &child.patches));
        let count = parent.basis.len();
        let mut values = vec![0.0; child.basis.len() * count];
        for WeightedNode { node, weight } in &measure.points {
            let [coarse, fine] = [parent, child].map(|element| functions(element, node));
            for (row, fine) in values.chunks_exact_mut(count).zip(fine) {
                row.iter_mut().zip(&coarse).for_each(|(value, coarse)| *value += weight * fine * coarse);
            }
        }
        Self { parent: count, values }
    }

    /// Adds H b of the parent's coefficients b to those of the child.
    pub(crate) fn push(&self, parent: &[f64], child: &mut [f64]) {
        for (row, child) in self.values.chunks_exact(self.parent).zip(child) {
            *child += dot(row, parent);
        }
    }

    /// Adds Hᵀ b of the child's coefficients b to those of the parent.
    pub(crate) fn pull(&self, child: &[f64], parent: &mut [f64]) {
        for (row, b) in self.values.chunks_exact(self.parent).zip(child) {
            parent.iter_mut().zip(row).for_each(|(parent, h)| *parent += h * b);
        }
    }
}

/// φ_k of an element at a point.
fn functions(element: &Element, node: &Node) -> Vec<f64> {
    let basis = &element.basis;
    let mut raw = vec![0.0; basis.len()];
    basis.raw(basis.frame().coordinates(node), &mut raw);
    basis.transform().chunks_exact(basis.len()).map(|row| dot(row, &raw)).collect()
}
