//! Integrals of a pattern q against the functions of an element,
//!
//! ```text
//! S_kl = ∫ q φ_k φ_l dA ,      e_k = ∫ q φ_k dA .
//! ```
//!
//! Where q is constant on texels, exact up to what [`tiles`](super::tiles) take together; where it is a
//! polynomial in the parameters, exact on affine elements, and to the accuracy of the area element on curved
//! ones.

use std::sync::Arc;

use radiosity_core::dot;
use radiosity_geom::Surface;
use radiosity_scene::Pattern;

use super::tiles::Tiles;
use crate::columns::transposed;
use crate::element::Element;
use crate::measure::{Measure, WeightedNode};
use crate::parameters::of_node;

/// A band of a pattern on an element.
#[derive(Debug)]
pub(super) struct ElementPattern {
    pattern: Arc<Pattern>,
    band: usize,
    /// The shape of the element's surface.
    pub(super) shape: Arc<dyn Surface>,
    pub(super) tiles: Tiles,
}

impl ElementPattern {
    /// A band of `pattern` on an element of a surface of this shape.
    pub(super) fn new(
        element: &Element,
        shape: &Arc<dyn Surface>,
        pattern: &Arc<Pattern>,
        band: usize,
    ) -> Self {
        let tiles = Tiles::of(pattern, band, &element.rect);
        Self { pattern: Arc::clone(pattern), band, shape: Arc::clone(shape), tiles }
    }

    /// Whether it is the same pattern.
    pub(super) fn is_as(&self, other: &Self) -> bool {
        let same = Arc::ptr_eq(&self.pattern, &other.pattern) || self.pattern == other.pattern;
        self.band == other.band && same
    }

    /// The largest q of the whole pattern.
    pub(super) fn most(&self) -> f64 {
        self.pattern.range(self.band)[1]
    }

    /// q at parameters of the surface.
    pub(super) fn at(&self, parameters: [f64; 2]) -> f64 {
        self.pattern.at(self.band, parameters)
    }

    /// S_kl, row-major.
    pub(super) fn matrix(&self, element: &Element) -> Vec<f64> {
        let n = element.basis.len();
        let mut sums = vec![0.0; n * n];
        self.integrate(element, 2, &mut |value, raw| {
            for (k, x) in raw.iter().enumerate() {
                let weighted = value * x;
                sums[k * n..k * n + k + 1].iter_mut().zip(raw).for_each(|(sum, y)| *sum += weighted * y);
            }
        });
        for k in 0..n {
            for l in k + 1..n {
                sums[k * n + l] = sums[l * n + k];
            }
        }
        orthonormal_rows(element, &transposed(&orthonormal_rows(element, &sums), n))
    }

    /// e_k, a number for each function of the element.
    pub(super) fn vector(&self, element: &Element) -> Vec<f64> {
        let mut sums = vec![0.0; element.basis.len()];
        self.integrate(element, 1, &mut |value, raw| {
            sums.iter_mut().zip(raw).for_each(|(sum, y)| *sum += value * y);
        });
        let n = sums.len();
        let rows = element.basis.transform().chunks_exact(n);
        rows.map(|row| dot(row, &sums)).collect()
    }

    /// Calls `add` with q times the area that a point stands for, and the raw functions there, for points
    /// that are exact for products of so many functions.
    fn integrate(&self, element: &Element, functions: usize, add: &mut dyn FnMut(f64, &[f64])) {
        let basis = &element.basis;
        let mut raw = vec![0.0; basis.len()];
        let degree = self.pattern.degree().map_or(0, |degree| degree as usize);
        for (rect, mean) in self.tiles.list() {
            let patches = element.patches_over(self.shape.as_ref(), &rect);
            let own = basis.space().chart_degree(basis.order(), &patches);
            let measure = Measure::new(&patches, (functions * own + degree).div_ceil(2));
            for WeightedNode { node, weight } in &measure.points {
                let value = mean
                    .unwrap_or_else(|| self.at(of_node(self.shape.as_ref(), node, element.plane.is_some())));
                basis.raw(basis.frame().coordinates(node), &mut raw);
                add(weight * value, &raw);
            }
        }
    }
}

/// T M for a square matrix M of as many rows as the element has functions, row-major.
pub(super) fn orthonormal_rows(element: &Element, matrix: &[f64]) -> Vec<f64> {
    let n = element.basis.len();
    let columns = matrix.len() / n;
    let mut out = vec![0.0; matrix.len()];
    for (row, t) in out.chunks_exact_mut(columns).zip(element.basis.transform().chunks_exact(n)) {
        for (t, line) in t.iter().zip(matrix.chunks_exact(columns)) {
            row.iter_mut().zip(line).for_each(|(out, x)| *out += t * x);
        }
    }
    out
}
