//! A function at the corners of cells of the unit square that are small where it is not bilinear.
//!
//! A cell is quartered while one of the new corners, its middle and those of its sides, differs from the bilinear interpolant of
//! its own corners. A few levels are always made, so that nothing larger than their cells is missed.

use std::collections::BTreeMap;
use std::num::NonZeroUsize;

use crate::zatz1993::mask::interpolation::{bilinear, nearest};

/// Cells along a side that are looked at in any case.
const LEAST_CELLS: usize = 8;

/// Difference from the interpolant that calls for quarters.
const TOLERANCE: f64 = 0.01;

/// A place on the finest grid.
type Knot = [usize; 2];

/// Values at the corners of the cells of a quadtree.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadtree {
    root: Cell<f64>,
    samples: usize,
}

#[derive(Clone, Debug, PartialEq)]
enum Cell<T> {
    /// What is at the corners (0, 0), (0, 1), (1, 0), (1, 1).
    Leaf([T; 4]),
    /// Index 2 a + b for the quarter in the a-th half of the first direction and the b-th of the second.
    Quarters(Box<[Cell<T>; 4]>),
}

impl<T: Copy> Cell<T> {
    fn map<U>(&self, change: &dyn Fn(T) -> U) -> Cell<U> {
        match self {
            Self::Leaf(corners) => Cell::Leaf(corners.map(change)),
            Self::Quarters(quarters) => Cell::Quarters(Box::new(quarters.each_ref().map(|q| q.map(change)))),
        }
    }
}

/// The samples taken so far.
struct Samples<'a> {
    finest: usize,
    sample: &'a dyn Fn([f64; 2]) -> Option<f64>,
    known: BTreeMap<Knot, Option<f64>>,
}

impl Quadtree {
    /// Of samples; its finest cells are no larger than those of a grid of `cells` × `cells`. None where nothing is known.
    pub fn new(cells: NonZeroUsize, sample: &dyn Fn([f64; 2]) -> Option<f64>) -> Option<Self> {
        let finest = cells.get().next_power_of_two();
        let mut samples = Samples { finest, sample, known: BTreeMap::new() };
        let root = samples.divide([0, 0], finest);
        let values = samples.filled()?;
        Some(Self { root: root.map(&|knot| values[&knot]), samples: values.len() })
    }

    /// The value at a place of the unit square.
    pub fn at(&self, place: [f64; 2]) -> f64 {
        let (mut cell, mut place) = (&self.root, place);
        loop {
            match cell {
                Cell::Leaf(corners) => return bilinear(*corners, place),
                Cell::Quarters(quarters) => {
                    let [a, b] = place.map(|x| usize::from(x >= 0.5));
                    place = [2.0 * place[0] - a as f64, 2.0 * place[1] - b as f64];
                    cell = &quarters[2 * a + b];
                }
            }
        }
    }

    /// Nodes that were sampled.
    pub fn samples(&self) -> usize {
        self.samples
    }
}

impl Samples<'_> {
    fn at(&mut self, knot: Knot) -> Option<f64> {
        let place = knot.map(|k| k as f64 / self.finest as f64);
        *self.known.entry(knot).or_insert_with(|| (self.sample)(place))
    }

    /// The cell of side `side` at a knot, quartered as far as needed.
    fn divide(&mut self, [i, j]: Knot, side: usize) -> Cell<Knot> {
        let corners = [[i, j], [i, j + side], [i + side, j], [i + side, j + side]];
        let values = corners.map(|knot| self.at(knot));
        if side == 1 || (side * LEAST_CELLS <= self.finest && !self.bends([i, j], side, values)) {
            return Cell::Leaf(corners);
        }
        let half = side / 2;
        let quarters = [[i, j], [i, j + half], [i + half, j], [i + half, j + half]];
        Cell::Quarters(Box::new(quarters.map(|quarter| self.divide(quarter, half))))
    }

    /// Whether the samples at the middles of a cell and of its sides are not those of the interpolant.
    fn bends(&mut self, [i, j]: Knot, side: usize, corners: [Option<f64>; 4]) -> bool {
        let half = side / 2;
        let middles = [[half, half], [0, half], [half, 0], [side, half], [half, side]];
        let mut samples = middles.map(|[a, b]| ([a, b], self.at([i + a, j + b]))).into_iter();
        let [Some(c00), Some(c01), Some(c10), Some(c11)] = corners else {
            // Covered as a whole, or worth a closer look.
            return corners.iter().any(Option::is_some) || samples.any(|(_, value)| value.is_some());
        };
        samples.any(|(knot, value)| {
            let place = knot.map(|k| k as f64 / side as f64);
            value.is_none_or(|value| (value - bilinear([c00, c01, c10, c11], place)).abs() > TOLERANCE)
        })
    }

    /// All samples; those where nothing is known take the nearest value.
    fn filled(&self) -> Option<BTreeMap<Knot, f64>> {
        let place = |knot: &Knot| knot.map(|k| k as f64);
        let known = || self.known.iter().map(|(knot, value)| (place(knot), value));
        let filled = |(knot, value): (&Knot, &Option<f64>)| {
            Some((*knot, value.or_else(|| nearest(place(knot), known()))?))
        };
        self.known.iter().map(filled).collect()
    }
}
