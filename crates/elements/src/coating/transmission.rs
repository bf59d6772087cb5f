//! Transmission: elements of two-sided surfaces that let light through, diffusely.
//!
//! What arrives on the element j of the other side leaves the element i with the transmittance τ:
//!
//! ```text
//! B_i(x) = … + τ E_j(x) ,      T_kl = τ ∫ φ_k^i φ_l^j dA
//! ```
//!
//! over what both share. Both sides have one τ, so the T of j and i is the transpose.

use std::sync::Arc;

use radiosity_geom::{DVec3, Plane, Rect, Surface, clip_polygon};

use super::element_pattern::orthonormal_rows;
use crate::columns::transposed;
use crate::element::{Element, overlap};
use crate::measure::{Measure, WeightedNode};
use crate::patch::Patch;

/// Transmission of an element, from all elements of the other side.
#[derive(Debug)]
pub(super) struct Transmission {
    /// The shape of both sides.
    pub shape: Arc<dyn Surface>,
    /// Transmittance τ.
    pub(super) transmittance: f64,
    /// Transmission from each element of the other side.
    pub(super) parts: Vec<TransmissionPart>,
}

impl Transmission {
    /// The element of the other side at these parameters: its covered part there, else its cell; where
    /// rounding leaves the point outside all of them, the first.
    pub(super) fn behind(&self, [u, v]: [f64; 2]) -> Option<usize> {
        let [part, ..] = &self.parts[..] else { return None };
        let covered = self.parts.iter().filter_map(|part| Some((part.behind, part.covered_part.as_deref()?)));
        let position = self.shape.jet(u, v).position;
        let covered = covered.into_iter().find(|(_, part)| part.covers(position, 0.0));
        let cell = || self.parts.iter().find(|part| part.covered_part.is_none() && part.rect.contains(u, v));
        Some(covered.map_or_else(|| cell().unwrap_or(part).behind, |(behind, _)| behind))
    }
}

/// Transmission of an element from one element of the other side.
#[derive(Clone, Debug)]
pub(super) struct TransmissionPart {
    /// The element of the other side.
    pub(super) behind: usize,
    /// The parameters that both cover.
    rect: Rect,
    /// The element of the other side, where another surface lies on it.
    covered_part: Option<Box<Element>>,
    /// T, row-major: as many rows as the element has functions.
    pub(super) matrix: Vec<f64>,
}

impl TransmissionPart {
    /// Transmission of `own` from the element number `behind`, which is `other`, on two sides of `shape`;
    /// None where they share nothing.
    pub(super) fn new(
        own: &Element,
        behind: usize,
        other: &Element,
        shape: &dyn Surface,
        transmittance: f64,
    ) -> Option<Self> {
        let rect = overlap(&own.rect, &other.rect)?;
        let patches = shared(own, other, shape, &rect);
        let degree = |element: &Element| element.basis.space().chart_degree(element.basis.order(), &patches);
        let measure = Measure::new(&patches, degree(own).max(degree(other)));
        let (rows, columns) = (own.basis.len(), other.basis.len());
        let (mut ours, mut theirs) = (vec![0.0; rows], vec![0.0; columns]);
        let mut sums = vec![0.0; rows * columns];
        for WeightedNode { node, weight } in &measure.points {
            own.basis.raw(own.basis.frame().coordinates(node), &mut ours);
            other.basis.raw(other.basis.frame().coordinates(node), &mut theirs);
            for (row, x) in sums.chunks_exact_mut(columns).zip(&ours) {
                let weighted = transmittance * weight * x;
                row.iter_mut().zip(&theirs).for_each(|(sum, y)| *sum += weighted * y);
            }
        }
        let half = transposed(&orthonormal_rows(own, &sums), columns);
        let matrix = transposed(&orthonormal_rows(other, &half), rows);
        let covered_part = other.contact.is_some().then(|| Box::new(other.clone()));
        (!patches.is_empty()).then_some(Self { behind, rect, covered_part, matrix })
    }
}

/// Patches of what two elements, on two sides of one shape, share over these parameters.
fn shared(own: &Element, other: &Element, shape: &dyn Surface, rect: &Rect) -> Vec<Patch> {
    let patches = own.patches_over(shape, rect);
    let Some(Plane { normal, .. }) = own.plane else { return patches };
    if own.contact.is_none() && other.contact.is_none() && own.patches.len() == 1 && other.patches.len() == 1
    {
        return patches;
    }
    let theirs: Vec<Vec<DVec3>> = other.patches_over(shape, rect).iter().map(Patch::polygon).collect();
    let both = patches
        .iter()
        .map(Patch::polygon)
        .flat_map(|own| theirs.iter().map(|window| common(&own, window, normal)).collect::<Vec<_>>());
    both.filter(|polygon| polygon.len() > 2).flat_map(|polygon| Patch::of_polygon(&polygon, normal)).collect()
}

/// The part of a convex polygon inside another of the same plane.
fn common(polygon: &[DVec3], window: &[DVec3], normal: DVec3) -> Vec<DVec3> {
    let middle = window.iter().sum::<DVec3>() / window.len() as f64;
    let edges = window.iter().zip(window.iter().cycle().skip(1));
    edges.fold(polygon.to_vec(), |part, (from, to)| {
        let inward = normal.cross(*to - *from);
        let inward = if inward.dot(middle - *from) < 0.0 { -inward } else { inward };
        clip_polygon(&part, *from, inward.normalize_or_zero())
    })
}
