//! Moments of W over a part of the outer patch, and how they are spread.
//!
//! ```text
//! M_kl = ∫ L_k W_l dA ,     S_dl = ∫ L_0 W_l z_d dA ,     z_d from −1 to 1 on the part
//! ```
//!
//! With many outer functions two rules that are both wrong hardly agree in all moments. With a single one they may
//! agree in its moment by chance, as where a horizon passes a few points: then the slopes S have to agree too.

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::measure::WeightedNode;
use radiosity_elements::patch::Patch;

use crate::estimates::entry_norm::EntryNorm;

/// The moments over a part of the outer patch.
#[derive(Clone, Debug)]
pub(super) struct Carried {
    /// Outer functions by inner ones, row-major.
    pub moments: Vec<f64>,
    /// The moments of a single outer function times either of the element's coordinates.
    slopes: [Vec<f64>; 2],
}

impl Carried {
    /// Nothing, for so many outer and inner functions.
    pub(super) fn nothing(rows: usize, columns: usize) -> Self {
        let slopes = [0, 1].map(|_| vec![0.0; if rows == 1 { columns } else { 0 }]);
        Self { moments: vec![0.0; rows * columns], slopes }
    }

    /// Adds the products of `left`, values of the outer polynomials at a point, and of W there.
    pub(super) fn add(&mut self, basis: &AreaBasis, point: &WeightedNode, left: &[f64], seen: &[f64]) {
        for (row, l) in self.moments.chunks_exact_mut(seen.len()).zip(left) {
            row.iter_mut().zip(seen).for_each(|(m, w)| *m += point.weight * l * w);
        }
        for (slopes, at) in self.slopes.iter_mut().zip(basis.frame().coordinates(&point.node)) {
            slopes.iter_mut().zip(seen).for_each(|(sum, w)| *sum += point.weight * at * left[0] * w);
        }
    }

    /// Numbers that it holds.
    pub(super) fn numbers(&self) -> usize {
        self.moments.len() + self.slopes.iter().map(Vec::len).sum::<usize>()
    }

    /// The sum over two parts.
    pub(super) fn sum([first, second]: [&Self; 2]) -> Self {
        let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + b).collect();
        let slopes = [0, 1].map(|d| sum(&first.slopes[d], &second.slopes[d]));
        Self { moments: sum(&first.moments, &second.moments), slopes }
    }

    /// Largest difference of two sums over one patch, in entries of the block.
    pub(super) fn difference(&self, other: &Self, patch: &Patch, basis: &AreaBasis, norm: &EntryNorm) -> f64 {
        let difference = norm.difference(&self.moments, &other.moments);
        if basis.len() > 1 {
            return difference;
        }
        let frame = basis.frame();
        let [middle, corners @ ..] = [(0.5, 0.5), (0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(s, t)| frame.coordinates(&patch.node(s, t)));
        let of_slope = |d: usize| {
            let range = corners.iter().map(|at| (at[d] - middle[d]).abs()).fold(0.0, f64::max);
            let spread = |own: &Self| -> Vec<f64> {
                let terms = own.slopes[d].iter().zip(&own.moments);
                terms.map(|(slope, moment)| (slope - middle[d] * moment) / range).collect()
            };
            norm.difference(&spread(self), &spread(other))
        };
        difference.max(of_slope(0)).max(of_slope(1))
    }
}
