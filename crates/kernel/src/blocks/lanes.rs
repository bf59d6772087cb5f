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

#[cfg(test)]
mod tests {
    use radiosity_work::ranks::Ranks;

    use super::super::Blocks;

    /// Elements of one to three functions, whole blocks and crosses.
    const STARTS: [usize; 5] = [0, 1, 4, 6, 9];

    fn number(k: usize) -> f64 {
        (k * 37 % 23) as f64 / 11.0 - 1.0
    }

    /// G with the entries that `Blocks` should hold, row-major.
    fn blocks(is_symmetric: bool) -> (Blocks, Vec<f64>) {
        let mut blocks = Blocks::empty(STARTS.to_vec(), is_symmetric, Ranks::alone());
        let mut entries = vec![0.0; 81];
        let mut set = |row: usize, column: usize, k: usize, l: usize, value: f64| {
            entries[9 * (STARTS[row] + k) + STARTS[column] + l] = value;
            if is_symmetric {
                entries[9 * (STARTS[column] + l) + STARTS[row] + k] = value;
            }
        };
        let size = |element: usize| STARTS[element + 1] - STARTS[element];
        for (row, column) in [(0, 1), (1, 3), (0, 3), (2, 3)] {
            let values: Vec<f64> =
                (0..size(row) * size(column)).map(|k| number(5 * row + column + k)).collect();
            blocks.push(row, column, &values);
            values.iter().enumerate().for_each(|(at, value)| {
                set(row, column, at / size(column), at % size(column), *value);
            });
        }
        if is_symmetric {
            let values: Vec<f64> = (0..size(1) + size(2) - 1).map(|k| number(k + 2)).collect();
            blocks.push_cross(1, 2, &values);
            for (at, value) in values.iter().enumerate() {
                let (k, l) = if at < size(2) { (0, at) } else { (at - size(2) + 1, 0) };
                set(1, 2, k, l, *value);
            }
        }
        (blocks, entries)
    }

    #[test]
    fn products_of_several_vectors_are_those_of_the_entries() {
        for is_symmetric in [false, true] {
            let (blocks, entries) = blocks(is_symmetric);
            for count in [0, 1, 8, 9, 19] {
                // Some are 0 on whole elements.
                let entry =
                    |c: usize, i: usize| if c.is_multiple_of(3) && i < 4 { 0.0 } else { number(9 * c + i) };
                let all: Vec<Vec<f64>> = (0..count).map(|c| (0..9).map(|i| entry(c, i)).collect()).collect();
                let found = blocks.apply_to_each(&all);
                assert_eq!(found.len(), count);
                for (x, y) in all.iter().zip(found) {
                    for (row, y) in entries.chunks_exact(9).zip(y) {
                        let right: f64 = row.iter().zip(x).map(|(g, x)| g * x).sum();
                        assert!((y - right).abs() < 1e-13, "{is_symmetric} {count}: {y} for {right}");
                    }
                }
            }
        }
    }
}
