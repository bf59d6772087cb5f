//! The functions of an element on one of its patches, as products along the two directions of the chart:
//!
//! ```text
//! T_m(s, t) = p_i(a₀ + a₁ s) p_j(b₀ + b₁ t)
//! ```
//!
//! so that sums over tensor grids factorise. Where the chart runs along the coordinates of the element's frame
//! (every curved patch, and parallelograms cut parallel to their sides), these are the element's raw functions
//! themselves. Elsewhere the patch has polynomials of its own, p_i(2s − 1) p_j(2t − 1): i + j ≤ D where the chart
//! is affine, i, j ≤ D where it is bilinear, D the highest total degree of the element's functions, and the element's functions
//! are combinations of them ([`Change`]).

use radiosity_core::{basis::total, legendre};

use crate::elements::basis::{AreaBasis, HIGHEST_ORDER};
use crate::elements::patch::Patch;

use super::change::Change;

/// Products on one patch that span an element's functions there.
#[derive(Debug)]
pub(super) struct Chart {
    degree: usize,
    /// (i, j) of each function.
    degrees: Vec<(usize, usize)>,
    axes: [Axis; 2],
    /// To the element's raw functions; None where the products are these.
    pub change: Option<Change>,
}

/// x = origin + slope · s.
#[derive(Clone, Copy, Debug)]
struct Axis {
    origin: f64,
    slope: f64,
}

/// From [0, 1] to [−1, 1].
const OWN: Axis = Axis { origin: -1.0, slope: 2.0 };

impl Chart {
    /// The element's raw functions where they are products along the patch, else the patch's own polynomials.
    pub(super) fn of(patch: &Patch, basis: &AreaBasis) -> Self {
        Self::aligned(patch, basis).unwrap_or_else(|| Self::own(patch, basis))
    }

    /// The patch's own polynomials.
    pub(super) fn own(patch: &Patch, basis: &AreaBasis) -> Self {
        let degree = basis.total_degree();
        let degrees: Vec<(usize, usize)> = if patch.is_parallelogram() {
            (0..total::count(degree)).map(total::degrees).collect()
        } else {
            (0..=degree).flat_map(|i| (0..=degree).map(move |j| (i, j))).collect()
        };
        let change = Change::projected(patch, basis, &degrees);
        Self { degree, degrees, axes: [OWN; 2], change: Some(change) }
    }

    /// Number of functions.
    pub(super) fn len(&self) -> usize {
        self.degrees.len()
    }

    /// Number of polynomials along either direction.
    pub(super) fn width(&self) -> usize {
        self.degree + 1
    }

    /// (i, j) of each function, along and across.
    pub(super) fn degrees(&self) -> &[(usize, usize)] {
        &self.degrees
    }

    /// p_n at the point s or t of one direction (0 along, 1 across), n = 0..[`Self::width`].
    pub(super) fn polynomials(&self, direction: usize, place: f64, out: &mut [f64]) {
        let Axis { origin, slope } = self.axes[direction];
        polynomials(origin + slope * place, &mut out[..self.degree + 1]);
    }

    fn aligned(patch: &Patch, basis: &AreaBasis) -> Option<Self> {
        let straight = !patch.is_flat() || patch.is_parallelogram();
        if !straight || !basis.is_product() {
            return None;
        }
        let at = |s: f64, t: f64| basis.frame().coordinates(&patch.node(s, t));
        let (origin, along, across) = (at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0));
        // Which coordinate of the frame changes along s, and which along t.
        let still = |k: usize, end: [f64; 2]| (end[k] - origin[k]).abs() <= 1e-13;
        let swapped = match (still(1, along) && still(0, across), still(0, along) && still(1, across)) {
            (true, _) => false,
            (_, true) => true,
            _ => return None,
        };
        let axis = |k: usize, end: [f64; 2]| Axis { origin: origin[k], slope: end[k] - origin[k] };
        let axes =
            if swapped { [axis(1, along), axis(0, across)] } else { [axis(0, along), axis(1, across)] };
        let place = |(i, j): (usize, usize)| if swapped { (j, i) } else { (i, j) };
        let degrees = basis.degrees().map(place).collect();
        Some(Self { degree: basis.order(), degrees, axes, change: None })
    }
}

/// p_n(x), n = 0..out.len().
pub(super) fn polynomials(x: f64, out: &mut [f64]) {
    match out.len() {
        0..=3 => recurrence::<3>(x, out),
        4..=5 => recurrence::<5>(x, out),
        6..=9 => recurrence::<9>(x, out),
        10..=21 => recurrence::<{ HIGHEST_ORDER + 1 }>(x, out),
        22..=42 => recurrence::<{ 2 * HIGHEST_ORDER + 2 }>(x, out),
        _ => legendre::orthonormal(x, out),
    }
}

fn recurrence<const N: usize>(x: f64, out: &mut [f64]) {
    let mut values = [0.0; N];
    legendre::Table::<N>::RECURRENCE.values(x, &mut values);
    out.copy_from_slice(&values[..out.len()]);
}
