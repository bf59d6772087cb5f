//! The area-orthonormal basis of an element: polynomials of order N in its coordinates (a, b), of one of two
//! [spaces](super::space),
//!
//! ```text
//! φ_k = Σ_{l ≤ k} T_kl R_l ,      ∫ φ_k φ_l dA = δ_kl        (φ_k in 1/length).
//! ```
//!
//! The raw functions R, which are evaluated at points, are
//!
//! * products of Legendre polynomials (`products`) with T triangular, where that keeps all digits: on
//!   parallelograms and most curved elements. Rules may then be factorised;
//! * else the φ themselves by their `recurrence`, T = 1. For total degree the frame of a planar element is
//!   then turned along its diameter.
//!
//! φ₀ is constant, so constants are in the span and power is conserved to rounding. (The
//! parameter-orthonormal basis of Zatz 1993, eq. 7, differs from this one on every element whose area element
//! varies.)

use radiosity_core::dot;
use radiosity_geom::DVec3;
use radiosity_scene::MAX_ORDER;

use super::columns::add_scaled;
pub use super::frame::Frame;
use super::measure::{Measure, WeightedNode};
use super::patch::{Node, Patch};
use super::products;
use super::recurrence::{Recurrence, WeightedPoint};
use super::rule::UnitRule;
use super::space::Space;

/// Highest order offered.
pub const HIGHEST_ORDER: usize = MAX_ORDER;

/// Loss of orthonormality up to which no better way of evaluation is tried: rounding of sums over some
/// hundreds of points.
const GOOD_DEFECT: f64 = 1e-13;

/// Largest loss of orthonormality of a basis that is accepted: solutions are off by as much. With a smaller
/// value thin elements of high order are refused more often.
const LARGEST_DEFECT: f64 = 1e-10;

/// Levels of products that a recurrence uses, cheapest first; measured in the table of the module
/// `recurrence`.
const DEPTHS: [usize; 2] = [1, 3];

/// Polynomials of order N, orthonormal with respect to area.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaBasis {
    space: Space,
    order: usize,
    frame: Frame,
    /// The raw functions if they are not products.
    recurrence: Option<Recurrence>,
    /// T, row-major, lower triangular, `len × len`.
    transform: Vec<f64>,
}

impl AreaBasis {
    /// The basis of total degree `order` over `patches`, preferably in `frame`.
    ///
    /// None where the element has no area, or is so thin that its rounded points cannot distinguish the
    /// polynomials.
    pub fn new(order: usize, frame: Frame, patches: &[Patch]) -> Option<Self> {
        Self::over(&Measure::new(patches, order), Space::Total, order, frame, patches)
    }

    /// The basis of `space` on a measure that is exact for products of two of its functions, preferably in
    /// `frame`; a tensor space depends on the frame. None as for [`AreaBasis::new`].
    pub(crate) fn over(
        measure: &Measure,
        space: Space,
        order: usize,
        frame: Frame,
        patches: &[Patch],
    ) -> Option<Self> {
        if measure.area().is_nan() || measure.area() <= 0.0 {
            return None;
        }
        let turned = match space {
            Space::Total => turned(&frame, patches),
            Space::Tensor => frame.clone(),
        };
        let products = std::iter::once_with(|| Self::by_products(measure, space, order, frame.clone()));
        let recurrences =
            DEPTHS.iter().map(|depth| Self::by_recurrence(measure, space, order, turned.clone(), *depth));
        let mut best: Option<(Self, f64)> = None;
        for (basis, defect) in products.chain(recurrences).flatten() {
            if best.as_ref().is_none_or(|(_, least)| defect < *least) {
                best = Some((basis, defect));
            }
            if defect <= GOOD_DEFECT {
                break;
            }
        }
        best.filter(|(_, defect)| *defect <= LARGEST_DEFECT).map(|(basis, _)| basis)
    }

    fn by_products(measure: &Measure, space: Space, order: usize, frame: Frame) -> Option<(Self, f64)> {
        let mut basis = Self { space, order, frame, recurrence: None, transform: Vec::new() };
        let table = basis.weighted_table(measure);
        basis.transform = products::orthonormalise(&table, basis.len())?;
        let defect = products::defect(&table, &basis.transform);
        Some((basis, defect))
    }

    fn by_recurrence(
        measure: &Measure,
        space: Space,
        order: usize,
        frame: Frame,
        depth: usize,
    ) -> Option<(Self, f64)> {
        let point = |WeightedNode { node, weight }: &WeightedNode| WeightedPoint {
            coordinates: frame.coordinates(node),
            weight: *weight,
        };
        let points: Vec<WeightedPoint> = measure.points.iter().map(point).collect();
        let recurrence = Recurrence::new(&points, &space.levels(order), depth)?;
        let mut basis = Self { space, order, frame, recurrence: Some(recurrence), transform: Vec::new() };
        let count = basis.len();
        basis.transform = vec![0.0; count * count];
        basis.transform.iter_mut().step_by(count + 1).for_each(|diagonal| *diagonal = 1.0);
        let defect = products::defect(&basis.weighted_table(measure), &basis.transform);
        Some((basis, defect))
    }

    /// Which polynomials it spans.
    pub fn space(&self) -> Space {
        self.space
    }

    /// N: the total degree, or the degree in each coordinate.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Highest total degree of its functions, which rules for corners and edges of contact need.
    pub fn total_degree(&self) -> usize {
        self.space.total_degree(self.order)
    }

    /// Number of functions.
    pub fn len(&self) -> usize {
        self.space.count(self.order)
    }

    /// False: the constant is always there.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// Whether the raw functions are products p_i(a) p_j(b) of the frame's coordinates, in the order of the
    /// space.
    pub fn is_product(&self) -> bool {
        self.recurrence.is_none()
    }

    /// Degrees (i, j) of the products p_i(a) p_j(b) of the space, in order.
    pub fn degrees(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.len()).map(|k| self.space.degrees(self.order, k))
    }

    /// The coordinates in which the polynomials are written.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// T, row-major, lower triangular: φ_k = Σ_l T_kl R_l.
    pub fn transform(&self) -> &[f64] {
        &self.transform
    }

    /// R_k at (a, b) into `out` (length [`AreaBasis::len`]).
    pub fn raw(&self, coordinates: [f64; 2], out: &mut [f64]) {
        match &self.recurrence {
            None => products::values(self.space, self.order, coordinates, out),
            Some(recurrence) => recurrence.values(coordinates, out),
        }
    }

    /// φ_k at a node, for all k.
    pub fn values(&self, node: &Node) -> Vec<f64> {
        let mut raw = vec![0.0; self.len()];
        self.raw(self.frame.coordinates(node), &mut raw);
        self.transform.chunks_exact(self.len()).map(|row| dot(row, &raw)).collect()
    }

    /// R_0, the same everywhere.
    pub fn constant(&self) -> f64 {
        let mut values = vec![0.0; self.len()];
        self.raw([0.0; 2], &mut values);
        values[0]
    }

    /// Coefficients c of Σ_k x_k φ_k = Σ_l c_l R_l, that is c = Tᵀ x.
    pub fn to_raw(&self, coefficients: &[f64]) -> Vec<f64> {
        let n = self.len();
        let mut raw = vec![0.0; n];
        for (k, x) in coefficients.iter().enumerate() {
            for (r, t) in raw.iter_mut().zip(&self.transform[k * n..=k * n + k]) {
                *r += x * t;
            }
        }
        raw
    }

    /// Coefficients of Σ_k x_k φ_k in the products p_i(a) p_j(b), in the order of the space.
    ///
    /// Exact up to rounding, which the products amplify where the element fills only a small part of its
    /// frame.
    pub fn to_products(&self, coefficients: &[f64]) -> Vec<f64> {
        let raw = self.to_raw(coefficients);
        if self.is_product() {
            return raw;
        }
        let mut products = vec![0.0; self.len()];
        let (mut ours, mut theirs) = (products.clone(), products.clone());
        let rule = UnitRule::of(self.order + 1);
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let place = [2.0 * s - 1.0, 2.0 * t - 1.0];
            self.raw(place, &mut ours);
            products::values(self.space, self.order, place, &mut theirs);
            // Four: the measure of [−1, 1]² against that of the unit square.
            add_scaled(&mut products, 4.0 * ws * wt * dot(&raw, &ours), &theirs);
        }
        products
    }

    /// One row per point: √w R_k.
    fn weighted_table(&self, measure: &Measure) -> Vec<Vec<f64>> {
        let row = |WeightedNode { node, weight }: &WeightedNode| {
            let mut row = vec![0.0; self.len()];
            self.raw(self.frame.coordinates(node), &mut row);
            row.iter_mut().for_each(|value| *value *= weight.sqrt());
            row
        };
        measure.points.iter().map(row).collect()
    }
}

/// The frame along the diameter, where the element is flat.
fn turned(frame: &Frame, patches: &[Patch]) -> Frame {
    let corners: Vec<DVec3> = patches.iter().filter(|p| p.is_flat()).flat_map(Patch::polygon).collect();
    match patches.first() {
        Some(Patch::Flat { normal, .. }) => Frame::along_diameter(&corners, *normal),
        _ => frame.clone(),
    }
}

#[cfg(test)]
mod tests;
