//! Several vectors side by side, so that a block is read once for all of them.

use std::ops::Range;

/// Vectors side by side: eight numbers fill a register of 512 bits.
pub(super) const WIDTH: usize = 8;

/// The entries of up to [`WIDTH`] vectors, those of the same index beside each other; lanes beyond them are 0.
pub(super) struct Lanes(Vec<[f64; WIDTH]>);

impl Lanes {
    /// The lanes of some vectors of the same length.
    pub(super) fn of(vectors: &[Vec<f64>]) -> Self {
        let mut lanes = Self::zero(vectors.first().map_or(0, Vec::len));
        for (lane, vector) in vectors.iter().enumerate() {
            lanes.0.iter_mut().zip(vector).for_each(|(all, x)| all[lane] = *x);
        }
        lanes
    }

    /// Zeros.
    pub(super) fn zero(length: usize) -> Self {
        Self(vec![[0.0; WIDTH]; length])
    }

    /// The vector of one lane.
    pub(super) fn lane(&self, lane: usize) -> Vec<f64> {
        self.0.iter().map(|all| all[lane]).collect()
    }

    /// Adds G x to the entries `place`, for a row-major G and the entries `columns` of x.
    pub(super) fn add_product(&mut self, place: Range<usize>, g: &[f64], x: &Self, columns: Range<usize>) {
        let x = &x.0[columns];
        if x.iter().flatten().all(|x| *x == 0.0) {
            return;
        }
        for (y, line) in self.0[place].iter_mut().zip(g.chunks_exact(x.len())) {
            line.iter().zip(x).for_each(|(g, x)| add_multiple(*g, x, y));
        }
    }

    /// Adds Gᵀ x to the entries `place`, for a row-major G and the entries `rows` of x.
    pub(super) fn add_transposed_product(
        &mut self,
        place: Range<usize>,
        g: &[f64],
        x: &Self,
        rows: Range<usize>,
    ) {
        let x = &x.0[rows];
        if x.iter().flatten().all(|x| *x == 0.0) {
            return;
        }
        let y = &mut self.0[place];
        for (line, x) in g.chunks_exact(y.len()).zip(x) {
            line.iter().zip(y.iter_mut()).for_each(|(g, y)| add_multiple(*g, x, y));
        }
    }
}

/// y ← y + g x in each lane.
fn add_multiple(g: f64, x: &[f64; WIDTH], y: &mut [f64; WIDTH]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += g * x);
}
