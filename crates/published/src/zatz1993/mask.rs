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
//! truth. The weighted one is exact at its nodes for an even emitter. Both are known at the corners of cells
//! of the element's coordinates and bilinear in between. The plain one has equal cells, as the paper has
//! them; the weighted one a quadtree, whose cells are halved where the values at the corners and the middle
//! of a cell differ, so that the finest follow the edge of the shadow. Nodes where something stands on the
//! element have no value of their own; they take that of the nearest free node, so that the interpolation
//! does not darken the rim around the contact.

use std::collections::BTreeMap;
use std::num::NonZeroUsize;

use serde::{Deserialize, Serialize};

/// The mask at coordinates in [−1, 1]²; None where the element is covered or does not reach.
pub(super) type Sample<'a> = &'a dyn Fn([f64; 2]) -> Option<f64>;

/// Fewest cells along each side with which a quadtree begins: a shadow that falls between their corners and
/// middles is missed. Chosen.
const FEWEST: usize = 8;

/// Difference of the values of a cell above which it is halved. Chosen: docs/theory/visibility.md has what it
/// does.
const DIFFERENCE: f64 = 0.03;

/// A function on an element with values in [0, 1], bilinear on each of its cells.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Mask {
    /// Cells along each side, were all as fine as the finest may be.
    cells: usize,
    /// Number of nodes that were sampled.
    samples: usize,
    /// Cells along each side before any is halved.
    roots: usize,
    /// These cells, the second coordinate fastest.
    tree: Vec<Cell>,
}

/// A cell: the values at its corners (0, 0), (0, 1), (1, 0), (1, 1), or its quarters in that order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
enum Cell {
    Whole([f64; 4]),
    Halved(Box<[Self; 4]>),
}

impl Mask {
    /// The mask of samples at the corners of `cells` × `cells` equal cells; None where no node is free.
    pub(super) fn uniform(cells: NonZeroUsize, sample: Sample<'_>) -> Option<Self> {
        Self::halved(cells.get(), 0, sample)
    }

    /// The mask of samples at the corners of a quadtree, of which `cells` × `cells` would be the finest; None
    /// where no node is free.
    pub(super) fn quadtree(cells: NonZeroUsize, sample: Sample<'_>) -> Option<Self> {
        let (mut roots, mut halvings) = (cells.get(), 0);
        while roots % 2 == 0 && roots / 2 >= FEWEST {
            roots /= 2;
            halvings += 1;
        }
        Self::halved(roots, halvings, sample)
    }

    fn halved(roots: usize, halvings: u32, sample: Sample<'_>) -> Option<Self> {
        let mut lattice = Lattice { side: roots << halvings, sample, known: BTreeMap::new() };
        let step = 1 << halvings;
        let place = |k: usize| [k / roots * step, k % roots * step];
        let tree: Vec<Outline> = (0..roots * roots).map(|k| lattice.outline(place(k), step)).collect();
        let samples = lattice.known.len();
        let tree = tree.iter().map(|own| own.cell(&lattice)).collect::<Option<_>>()?;
        Some(Self { cells: roots << halvings, samples, roots, tree })
    }

    /// Whether there are values from 0 to 1 in all its cells.
    pub(super) fn is_valid(&self) -> bool {
        let count = self.roots.checked_mul(self.roots);
        let is_cut = self.roots > 0 && count == Some(self.tree.len()) && self.cells >= self.roots;
        is_cut && self.tree.iter().all(Cell::is_valid)
    }

    /// Cells along each side, were all as fine as the finest may be.
    pub(super) fn cells(&self) -> usize {
        self.cells
    }

    /// Number of nodes that were sampled.
    pub(super) fn samples(&self) -> usize {
        self.samples
    }

    /// Mean over [−1, 1]².
    pub(super) fn mean(&self) -> f64 {
        self.tree.iter().map(Cell::mean).sum::<f64>() / self.tree.len() as f64
    }

    /// Value at coordinates in [−1, 1]²; coordinates outside count as on the border.
    pub(super) fn at(&self, coordinates: [f64; 2]) -> f64 {
        let scaled = coordinates.map(|x| (0.5 * (x + 1.0)).clamp(0.0, 1.0) * self.roots as f64);
        let [i, j] = scaled.map(|x| (x as usize).min(self.roots - 1));
        self.tree[i * self.roots + j].at([scaled[0] - i as f64, scaled[1] - j as f64])
    }
}

impl Cell {
    fn is_valid(&self) -> bool {
        match self {
            Self::Whole(corners) => corners.iter().all(|own| (0.0..=1.0).contains(own)),
            Self::Halved(quarters) => quarters.iter().all(Self::is_valid),
        }
    }

    fn mean(&self) -> f64 {
        match self {
            Self::Whole(corners) => 0.25 * corners.iter().sum::<f64>(),
            Self::Halved(quarters) => 0.25 * quarters.iter().map(Self::mean).sum::<f64>(),
        }
    }

    /// Value at a place in [0, 1]² of the cell.
    fn at(&self, place: [f64; 2]) -> f64 {
        match self {
            Self::Whole(corners) => bilinear(*corners, place),
            Self::Halved(quarters) => {
                let half = place.map(|x| usize::from(x >= 0.5));
                quarters[2 * half[0] + half[1]].at([0, 1].map(|k| 2.0 * place[k] - half[k] as f64))
            }
        }
    }
}

/// A cell whose values are sampled: its corners on the lattice, or its quarters.
enum Outline {
    Whole([[usize; 2]; 4]),
    Halved(Box<[Self; 4]>),
}

impl Outline {
    /// The cell with its values; None where no node is free.
    fn cell(&self, lattice: &Lattice<'_>) -> Option<Cell> {
        Some(match self {
            Self::Whole(corners) => {
                let [a, b, c, d] = corners.map(|node| lattice.value(node));
                Cell::Whole([a?, b?, c?, d?])
            }
            Self::Halved(quarters) => {
                let [a, b, c, d] = quarters.each_ref().map(|own| own.cell(lattice));
                Cell::Halved(Box::new([a?, b?, c?, d?]))
            }
        })
    }
}

/// The nodes of the finest cells, as far as they were sampled.
struct Lattice<'a> {
    /// The finest cells along each side.
    side: usize,
    sample: Sample<'a>,
    known: BTreeMap<[usize; 2], Option<f64>>,
}

impl Lattice<'_> {
    /// The cell of so many of the finest along each side, halved while its values differ.
    fn outline(&mut self, [i, j]: [usize; 2], step: usize) -> Outline {
        let corners = [[i, j], [i, j + step], [i + step, j], [i + step, j + step]];
        corners.iter().for_each(|node| self.visit(*node));
        if step == 1 {
            return Outline::Whole(corners);
        }
        let half = step / 2;
        let middle = [i + half, j + half];
        self.visit(middle);
        let values = || corners.iter().chain([&middle]).filter_map(|node| self.known[node]);
        let [least, most] = [values().fold(1.0, f64::min), values().fold(0.0, f64::max)];
        if most - least <= DIFFERENCE {
            return Outline::Whole(corners);
        }
        let quarters = [[i, j], [i, j + half], [i + half, j], [i + half, j + half]];
        Outline::Halved(Box::new(quarters.map(|corner| self.outline(corner, half))))
    }

    fn visit(&mut self, node: [usize; 2]) {
        let place = self.place(node);
        let sample = self.sample;
        self.known.entry(node).or_insert_with(|| sample(place));
    }

    fn place(&self, node: [usize; 2]) -> [f64; 2] {
        node.map(|k| 2.0 * k as f64 / self.side as f64 - 1.0)
    }

    /// The value at a node; where it has none of its own the one at the nearest node that has.
    fn value(&self, node: [usize; 2]) -> Option<f64> {
        let places = self.known.iter().map(|(node, value)| (self.place(*node), value));
        self.known[&node].or_else(|| nearest(self.place(node), places))
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
            let mask = Mask::uniform(cells(count), &|place| Some(f(place))).expect("all is known");
            prop_assert!((mask.at([u, v]) - f([u, v])).abs() < 1e-14);
        }

        /// Except near the shadow's edge a mask has the values of light or dark; no value leaves the range of
        /// the samples.
        #[test]
        fn steps_stay_where_they_are(angle in 0.0..std::f64::consts::TAU, u in -1.0..1.0, v in -1.0..1.0) {
            let (sin, cos) = angle.sin_cos();
            let height = |[u, v]: [f64; 2]| u * cos + v * sin;
            let mask = Mask::quadtree(cells(32), &|place| Some(f64::from(height(place) > 0.0))).expect("known");
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
        let mask = Mask::quadtree(cells(16), &|x| (!covered(x)).then_some(0.75)).expect("the rim is free");
        for place in [[-0.21, 0.1], [0.3, 0.1], [-1.0, 1.0], [0.51, 0.61]] {
            assert_eq!(mask.at(place), 0.75);
        }
        assert_eq!(Mask::quadtree(cells(16), &|_| None), None);
    }

    /// The edge of a disk of light: the quadtree has the values of equal cells within what its cells may
    /// differ by, with a third of the samples.
    #[test]
    fn quadtrees_follow_the_edge() {
        let disk = |[u, v]: [f64; 2]| Some(((0.55 - u.hypot(v)) / 0.1).clamp(0.0, 1.0));
        let [fine, tree] = [Mask::uniform, Mask::quadtree].map(|make| make(cells(64), &disk).expect("known"));
        assert!(3 * tree.samples() < fine.samples() && fine.samples() == 65 * 65, "{}", tree.samples());
        for place in (0..400).map(|k| [f64::from(k % 20) / 9.7 - 1.0, f64::from(k / 20) / 9.9 - 1.0]) {
            assert!((tree.at(place) - fine.at(place)).abs() < 2.0 * DIFFERENCE);
        }
        assert!((tree.mean() - fine.mean()).abs() < 1e-3);
    }

    #[test]
    fn a_number_of_cells_without_halves_makes_equal_cells() {
        let disk = |[u, v]: [f64; 2]| Some(f64::from(u.hypot(v) < 0.5));
        assert_eq!(Mask::quadtree(cells(7), &disk), Mask::uniform(cells(7), &disk));
    }
}
