//! A function at the corners of equal cells of the unit square, bilinear in between.

use std::num::NonZeroUsize;

use crate::zatz1993::mask::interpolation::{bilinear, nearest};

/// Values at (cells + 1)² nodes, b running fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    cells: usize,
    values: Vec<f64>,
}

impl Grid {
    /// Of samples at all nodes; None where none is known.
    pub fn new(cells: NonZeroUsize, sample: &dyn Fn([f64; 2]) -> Option<f64>) -> Option<Self> {
        let cells = cells.get();
        let place =
            |index: usize| [index / (cells + 1), index % (cells + 1)].map(|k| k as f64 / cells as f64);
        let count = (cells + 1) * (cells + 1);
        let known: Vec<Option<f64>> = (0..count).map(|index| sample(place(index))).collect();
        let places = || (0..count).map(place).zip(&known);
        let filled = (0..count).map(|index| known[index].or_else(|| nearest(place(index), places())));
        Some(Self { cells, values: filled.collect::<Option<_>>()? })
    }

    /// The value at a place of the unit square.
    pub fn at(&self, place: [f64; 2]) -> f64 {
        let scaled = place.map(|x| x * self.cells as f64);
        let [i, j] = scaled.map(|x| (x as usize).min(self.cells - 1));
        let node = |i: usize, j: usize| self.values[i * (self.cells + 1) + j];
        let corners = [node(i, j), node(i, j + 1), node(i + 1, j), node(i + 1, j + 1)];
        bilinear(corners, [scaled[0] - i as f64, scaled[1] - j as f64])
    }

    /// Nodes that were sampled.
    pub fn samples(&self) -> usize {
        self.values.len()
    }
}
