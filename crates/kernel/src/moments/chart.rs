//! The functions of an element on one of its patches, as products along the two directions of the chart:
//!
//! ```text
//! T_m(s, t) = p_i(a₀ + a₁ s) p_j(b₀ + b₁ t)
//! ```
//!
//! so that sums over tensor grids factorise. Where the chart runs along the coordinates of the element's
//! frame (every curved patch; parallelograms cut parallel to their sides), these are the element's raw
//! functions. Elsewhere the patch has its own polynomials p_i(2s − 1) p_j(2t − 1) and the element's functions
//! are combinations of them ([`Change`]). With D the highest total degree of these functions, i + j ≤ D where
//! the chart is affine, and i, j ≤ D where it is bilinear.

use radiosity_core::basis::total;
use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::Patch;

use crate::moments::change::Change;
use crate::moments::legendre_values::polynomials;

/// Products on one patch that span an element's functions there.
#[derive(Debug)]
pub(crate) struct Chart {
    degree: usize,
    /// (i, j) of each function.
    degrees: Vec<(usize, usize)>,
    axes: [Axis; 2],
    /// The change to the element's raw functions; None where the products are those.
    pub change: Option<Change>,
}

/// x = origin + slope · s.
#[derive(Clone, Copy, Debug)]
struct Axis {
    origin: f64,
    slope: f64,
}

/// The affine map from [0, 1] to [−1, 1].
const OWN: Axis = Axis { origin: -1.0, slope: 2.0 };

impl Chart {
    /// The element's raw functions where they are products along the patch, else the patch's own polynomials.
    pub(crate) fn of(patch: &Patch, basis: &AreaBasis) -> Self {
        Self::aligned(patch, basis).unwrap_or_else(|| Self::own(patch, basis))
    }

    pub(crate) fn own(patch: &Patch, basis: &AreaBasis) -> Self {
        let degree = basis.total_degree();
        let degrees: Vec<(usize, usize)> = if patch.is_parallelogram() {
            (0..total::count(degree)).map(total::degrees).collect()
        } else {
            (0..=degree).flat_map(|i| (0..=degree).map(move |j| (i, j))).collect()
        };
        let change = Change::projected(patch, basis, &degrees);
        Self { degree, degrees, axes: [OWN; 2], change: Some(change) }
    }

    pub(crate) fn len(&self) -> usize {
        self.degrees.len()
    }

    /// Number of polynomials along either direction.
    pub(crate) fn width(&self) -> usize {
        self.degree + 1
    }

    /// (i, j) of each function, along and across.
    pub(crate) fn degrees(&self) -> &[(usize, usize)] {
        &self.degrees
    }

    /// p_n at the parameter `place` of one direction (0 along, 1 across), n = 0..[`Self::width`].
    pub(crate) fn polynomials(&self, direction: usize, place: f64, out: &mut [f64]) {
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
        // Which coordinate of the frame changes along s, and which along t, to 1e-13.
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
