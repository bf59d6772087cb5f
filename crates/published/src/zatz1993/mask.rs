//! Shadow masks: the part of an emitter that each place of an element sees.
//!
//! Zatz 1993, section 5.1: light from an emitter h is kept without shadows as a polynomial of the receiver i,
//! and multiplied by a mask wherever it is read or sent on:
//!
//! ```text
//! E_i(x) = M_{i←h}(x) Σ_k p_k φ_k(x) ,      p = G°_{ih} b_h      (G°: without visibility),   0 ≤ M ≤ 1
//!
//! plain:     M = ∬ V du dv / ∬ du dv                 (eq. 28)
//! weighted:  M = ∫ κ V dA_h / ∫ κ dA_h
//! ```
//!
//! On a curved receiver the weighted mask holds the cosine there, too ([`super::solid_angle`]).
//!
//! The plain mask is the paper's; it ignores cosines and distance, and finer masks do not converge to the
//! truth. The weighted one is exact at its nodes for an even emitter. Both are known at the corners of equal
//! cells of the element's coordinates and bilinear in between. Nodes where something stands on the element
//! have no value of their own; they take that of the nearest free node, so that the interpolation does not
//! darken the rim around the contact.

use std::num::NonZeroUsize;

use serde::{Deserialize, Serialize};

/// The mask at coordinates in [−1, 1]²; None where the element is covered or does not reach.
pub(super) type Sample<'a> = &'a dyn Fn([f64; 2]) -> Option<f64>;

/// A function on an element with values in [0, 1], given at (cells + 1)² nodes, the second coordinate
/// fastest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Mask {
    cells: usize,
    values: Vec<f64>,
}

impl Mask {
    /// The mask of samples at the corners of `cells` × `cells` equal cells; None where no node is free.
    pub(super) fn new(cells: NonZeroUsize, sample: Sample<'_>) -> Option<Self> {
        let cells = cells.get();
        let place = |index: usize| {
            [index / (cells + 1), index % (cells + 1)].map(|k| 2.0 * k as f64 / cells as f64 - 1.0)
        };
        let count = (cells + 1) * (cells + 1);
        let known: Vec<Option<f64>> = (0..count).map(|index| sample(place(index))).collect();
        let places = || (0..count).map(place).zip(&known);
        let filled = (0..count).map(|index| known[index].or_else(|| nearest(place(index), places())));
        Some(Self { cells, values: filled.collect::<Option<_>>()? })
    }

    /// Whether there is a finite value at each node.
    pub(super) fn is_valid(&self) -> bool {
        let nodes = self.cells.checked_add(1).and_then(|nodes| nodes.checked_mul(nodes));
        self.cells > 0 && nodes == Some(self.values.len()) && self.values.iter().all(|own| own.is_finite())
    }

    /// Cells along each side.
    pub(super) fn cells(&self) -> usize {
        self.cells
    }

    /// Mean over [−1, 1]².
    pub(super) fn mean(&self) -> f64 {
        let cells = self.cells;
        let share = |k: usize| if k == 0 || k == cells { 0.5 } else { 1.0 };
        let weighted = |(index, value): (usize, &f64)| {
            share(index / (cells + 1)) * share(index % (cells + 1)) * value
        };
        self.values.iter().enumerate().map(weighted).sum::<f64>() / (cells * cells) as f64
    }

    /// Value at coordinates in [−1, 1]²; coordinates outside count as on the border.
    pub(super) fn at(&self, coordinates: [f64; 2]) -> f64 {
        let scaled = coordinates.map(|x| (0.5 * (x + 1.0)).clamp(0.0, 1.0) * self.cells as f64);
        let [i, j] = scaled.map(|x| (x as usize).min(self.cells - 1));
        let node = |i: usize, j: usize| self.values[i * (self.cells + 1) + j];
        let corners = [node(i, j), node(i, j + 1), node(i + 1, j), node(i + 1, j + 1)];
        bilinear(corners, [scaled[0] - i as f64, scaled[1] - j as f64])
    }
}

/// The bilinear interpolant of the corners (0, 0), (0, 1), (1, 0), (1, 1).
fn bilinear([c00, c01, c10, c11]: [f64; 4], [a, b]: [f64; 2]) -> f64 {
    (1.0 - a) * ((1.0 - b) * c00 + b * c01) + a * ((1.0 - b) * c10 + b * c11)
}

/// The known value nearest to `place`; the earliest of equally near ones.
fn nearest<'a>(place: [f64; 2], known: impl Iterator<Item = ([f64; 2], &'a Option<f64>)>) -> Option<f64> {
    let mut best: Option<(f64, f64)> = None;
    for (other, value) in known {
        let Some(value) = *value else { continue };
        let distance = (place[0] - other[0]).powi(2) + (place[1] - other[1]).powi(2);
        if best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, value));
        }
    }
    best.map(|(_, value)| value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cells(count: usize) -> NonZeroUsize {
        NonZeroUsize::new(count).expect("more than none")
    }

    proptest! {
        #[test]
        fn bilinear_functions_are_kept(
            c in [-1.0..1.0, -1.0..1.0, -1.0..1.0, -1.0..1.0], count in 1usize..20, u in -1.0..1.0, v in -1.0..1.0,
        ) {
            let f = |[u, v]: [f64; 2]| c[0] + c[1] * u + c[2] * v + c[3] * u * v;
            let mask = Mask::new(cells(count), &|place| Some(f(place))).expect("all is known");
            prop_assert!((mask.at([u, v]) - f([u, v])).abs() < 1e-14);
        }

        /// Except near the shadow's edge a mask has the values of light or dark; no value leaves the range of
        /// the samples.
        #[test]
        fn steps_stay_where_they_are(angle in 0.0..std::f64::consts::TAU, u in -1.0..1.0, v in -1.0..1.0) {
            let (sin, cos) = angle.sin_cos();
            let height = |[u, v]: [f64; 2]| u * cos + v * sin;
            let mask = Mask::new(cells(32), &|place| Some(f64::from(height(place) > 0.0))).expect("known");
            let value = mask.at([u, v]);
            prop_assert!((0.0..=1.0).contains(&value));
            // Cells are 1/16 wide.
            if height([u, v]).abs() > 2.0 / 16.0 {
                prop_assert_eq!(value, f64::from(height([u, v]) > 0.0));
            }
        }
    }

    /// A lit element on the middle of which something stands: the covered nodes do not darken the rim.
    #[test]
    fn covered_nodes_take_the_nearest_value() {
        let covered = |[u, v]: [f64; 2]| (-0.2..0.5).contains(&u) && (-0.6..0.6).contains(&v);
        let mask = Mask::new(cells(16), &|x| (!covered(x)).then_some(0.75)).expect("the rim is free");
        for place in [[-0.21, 0.1], [0.3, 0.1], [-1.0, 1.0], [0.51, 0.61]] {
            assert_eq!(mask.at(place), 0.75);
        }
        assert_eq!(Mask::new(cells(16), &|_| None), None);
    }
}
