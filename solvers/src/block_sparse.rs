//! A matrix of which most blocks are zero.
//!
//! The blocks that are not zero stand row by row (compressed rows, as in Y. Saad, *Iterative Methods for
//! Sparse Linear Systems*, 2nd ed., SIAM 2003, §3.4, with blocks in place of entries). Every y_i is summed in
//! the order of the columns, whatever thread does it: the number of threads never changes a bit.

use rayon::prelude::*;

use crate::error::SolveError;
use crate::operator::Operator;
use crate::partition::Partition;
use crate::vector::{add_scaled, all_finite, dot};

/// One block that may differ from zero.
#[derive(Clone, Copy, Debug)]
pub struct SparseBlock<'a> {
    /// Its row of blocks.
    pub row: usize,
    /// Its column of blocks.
    pub column: usize,
    /// Its entries, line by line.
    pub values: &'a [f64],
}

impl<'a> SparseBlock<'a> {
    /// The block in this row and column, with its entries line by line.
    pub fn new(row: usize, column: usize, values: &'a [f64]) -> Self {
        Self { row, column, values }
    }
}

/// A real square matrix, finite, of which only the blocks that differ from zero are held.
///
/// ```
/// use radiosity_solvers::{BlockSparse, Operator, Partition, SparseBlock};
///
/// // Blocks of 2 and 1 unknowns; of a symmetric matrix one triangle suffices.
/// let blocks = [
///     SparseBlock::new(0, 0, &[2.0, 0.5, 0.5, 2.0]),
///     SparseBlock::new(0, 1, &[1.0, 0.0]),
///     SparseBlock::new(1, 1, &[3.0]),
/// ];
/// let a = BlockSparse::symmetric(Partition::new(&[2, 1]), &blocks)?;
/// let mut y = [0.0; 3];
/// a.apply(&[1.0, 2.0, 3.0], &mut y);
/// assert_eq!(y, [6.0, 4.5, 10.0]);
/// # Ok::<(), radiosity_solvers::SolveError>(())
/// ```
#[derive(Clone, Debug)]
pub struct BlockSparse {
    partition: Partition,
    symmetric: bool,
    threads: usize,
    /// Where the places of each row of blocks start; one more, their number, at the end.
    rows: Vec<usize>,
    /// Column and first value of each block, row by row, columns ascending.
    places: Vec<Place>,
    /// Entries, block by block, line by line.
    values: Vec<f64>,
}

/// Where a block stands.
#[derive(Clone, Copy, Debug)]
struct Place {
    column: usize,
    start: usize,
}

/// A block on its way into the matrix; `transposed` where it is the mirror image of a block of the caller's.
struct Arriving<'a> {
    row: usize,
    column: usize,
    transposed: bool,
    values: &'a [f64],
}

impl BlockSparse {
    /// The matrix with these blocks; those in the same place add up.
    ///
    /// # Errors
    /// [`DimensionMismatch`](SolveError::DimensionMismatch) if a block has not as many entries as its place,
    /// [`NonFinite`](SolveError::NonFinite) if an entry is infinite or NaN.
    pub fn new<'a>(partition: Partition, blocks: &[SparseBlock<'a>]) -> Result<Self, SolveError> {
        let arriving = |SparseBlock { row, column, values }: SparseBlock<'a>| Arriving {
            row,
            column,
            transposed: false,
            values,
        };
        Self::of(partition, blocks.iter().copied().map(arriving).collect(), false)
    }

    /// The symmetric matrix of which these blocks are one triangle: each off the diagonal stands for its
    /// transpose as well.
    ///
    /// # Errors
    /// Errors of [`BlockSparse::new`].
    pub fn symmetric(partition: Partition, blocks: &[SparseBlock<'_>]) -> Result<Self, SolveError> {
        let mut arriving = Vec::with_capacity(2 * blocks.len());
        for SparseBlock { row, column, values } in blocks.iter().copied() {
            arriving.push(Arriving { row, column, transposed: false, values });
            if row != column {
                arriving.push(Arriving { row: column, column: row, transposed: true, values });
            }
        }
        Self::of(partition, arriving, true)
    }

    fn of(
        partition: Partition,
        mut arriving: Vec<Arriving<'_>>,
        symmetric: bool,
    ) -> Result<Self, SolveError> {
        arriving.sort_by_key(|block| (block.row, block.column));
        let mut matrix =
            Self { partition, symmetric, threads: 1, rows: vec![0], places: Vec::new(), values: Vec::new() };
        for block in &arriving {
            matrix.take(block)?;
        }
        matrix.rows.resize(matrix.partition.len() + 1, matrix.places.len());
        if !all_finite(&matrix.values) {
            return Err(SolveError::NonFinite { what: "the matrix" });
        }
        Ok(matrix)
    }

    /// Adds a block that stands nowhere before those taken already.
    fn take(&mut self, block: &Arriving<'_>) -> Result<(), SolveError> {
        let (height, width) = (self.partition.size(block.row), self.partition.size(block.column));
        let (expected, found) = (height * width, block.values.len());
        if expected != found {
            return Err(SolveError::DimensionMismatch { what: "a block", expected, found });
        }
        let is_next = self.rows.len() > block.row
            && self.places.len() > self.rows[block.row]
            && self.places[self.places.len() - 1].column == block.column;
        if !is_next {
            self.rows.resize(block.row + 1, self.places.len());
            self.places.push(Place { column: block.column, start: self.values.len() });
            self.values.resize(self.values.len() + expected, 0.0);
        }
        let start = self.values.len() - expected;
        for (k, value) in self.values[start..].iter_mut().enumerate() {
            let source = if block.transposed { k % width * height + k / width } else { k };
            *value += block.values[source];
        }
        Ok(())
    }

    /// Lets products with the whole matrix use up to `threads` threads of the current rayon pool.
    #[must_use]
    pub fn with_threads(self, threads: usize) -> Self {
        Self { threads: threads.max(1), ..self }
    }

    /// Number of entries held.
    pub fn stored(&self) -> usize {
        self.values.len()
    }

    /// The blocks of a row: column and entries.
    fn row(&self, row: usize) -> impl Iterator<Item = (usize, &[f64])> {
        let height = self.partition.size(row);
        self.places[self.rows[row]..self.rows[row + 1]].iter().map(move |place| {
            let length = height * self.partition.size(place.column);
            (place.column, &self.values[place.start..place.start + length])
        })
    }
}

impl Operator for BlockSparse {
    fn partition(&self) -> &Partition {
        &self.partition
    }

    fn gather(&self, row: usize, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        for (column, block) in self.row(row) {
            let x = &x[self.partition.range(column)];
            for (y, line) in y.iter_mut().zip(block.chunks_exact(x.len().max(1))) {
                *y += dot(line, x);
            }
        }
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        if self.symmetric {
            // Column j is row j, lines and columns exchanged.
            for (row, block) in self.row(column) {
                let y = &mut y[self.partition.range(row)];
                for (x, line) in x.iter().zip(block.chunks_exact(y.len().max(1))) {
                    add_scaled(*x, line, y);
                }
            }
            return;
        }
        for row in 0..self.partition.len() {
            let y = &mut y[self.partition.range(row)];
            for (_, block) in self.row(row).filter(|(other, _)| *other == column) {
                for (y, line) in y.iter_mut().zip(block.chunks_exact(x.len().max(1))) {
                    *y += dot(line, x);
                }
            }
        }
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let mut rows = Vec::with_capacity(self.partition.len());
        let mut rest = y;
        for row in 0..self.partition.len() {
            let (own, others) = rest.split_at_mut(self.partition.size(row));
            rows.push((row, own));
            rest = others;
        }
        if self.threads == 1 {
            rows.into_iter().for_each(|(row, y)| self.gather(row, x, y));
        } else {
            rows.into_par_iter().with_min_len(64).for_each(|(row, y)| self.gather(row, x, y));
        }
    }

    fn diagonal(&self, block: usize, out: &mut [f64]) {
        out.fill(0.0);
        let size = self.partition.size(block);
        for (_, values) in self.row(block).filter(|(column, _)| *column == block) {
            for (k, value) in values.iter().enumerate() {
                out[k % size * size + k / size] = *value;
            }
        }
    }

    fn symmetric(&self) -> bool {
        self.symmetric
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Blocks of 3, 1 and 2 unknowns, and the same matrix entry by entry.
    fn blocks() -> (Partition, Vec<(usize, usize, Vec<f64>)>) {
        let values = |count: usize, first: f64| (0..count).map(|k| first + k as f64).collect::<Vec<f64>>();
        let blocks = vec![
            (2, 0, values(6, 1.0)),
            (0, 0, values(9, 10.0)),
            (1, 2, values(2, 20.0)),
            (0, 0, values(9, 0.5)),
        ];
        (Partition::new(&[3, 1, 2]), blocks)
    }

    fn borrowed(blocks: &[(usize, usize, Vec<f64>)]) -> Vec<SparseBlock<'_>> {
        blocks.iter().map(|(row, column, values)| SparseBlock::new(*row, *column, values)).collect()
    }

    /// All entries by products with unit vectors, by rows and by columns.
    fn entries(a: &BlockSparse) -> [Vec<f64>; 3] {
        let dim = a.partition().dim();
        let mut ways = [vec![], vec![], vec![]];
        for j in 0..dim {
            let mut unit = vec![0.0; dim];
            unit[j] = 1.0;
            let mut y = vec![0.0; dim];
            a.apply(&unit, &mut y);
            ways[0].extend(&y);
            let shared = a.clone().with_threads(2);
            shared.apply(&unit, &mut y);
            ways[1].extend(&y);
            y.fill(0.0);
            let block = (0..a.partition().len()).find(|b| a.partition().range(*b).contains(&j));
            let block = block.expect("some block holds j");
            a.shoot(block, &unit[a.partition().range(block)], &mut y);
            ways[2].extend(&y);
        }
        ways
    }

    #[test]
    fn all_ways_to_multiply_agree() {
        let (partition, blocks) = blocks();
        let a = BlockSparse::new(partition.clone(), &borrowed(&blocks)).expect("blocks fit");
        let [rows, threads, columns] = entries(&a);
        let mut truth = vec![0.0; 36];
        for (row, column, values) in &blocks {
            let width = partition.size(*column);
            for (k, value) in values.iter().enumerate() {
                let (i, j) =
                    (partition.range(*row).start + k / width, partition.range(*column).start + k % width);
                truth[j * 6 + i] += value;
            }
        }
        assert_eq!([&rows, &threads, &columns], [&truth; 3]);
        let mut diagonal = vec![f64::NAN; 9];
        a.diagonal(0, &mut diagonal);
        assert_eq!(diagonal[..3], truth[..3]);
        a.diagonal(1, &mut diagonal[..1]);
        assert_eq!(diagonal[0], 0.0);
    }

    #[test]
    fn one_triangle_makes_a_symmetric_matrix() {
        let (partition, blocks) = blocks();
        let symmetric: Vec<_> = blocks.into_iter().filter(|(row, column, _)| row != column).collect();
        let a = BlockSparse::symmetric(partition, &borrowed(&symmetric)).expect("blocks fit");
        let [rows, _, columns] = entries(&a);
        assert_eq!(rows, columns);
        assert!((0..36).all(|k| rows[k] == rows[k % 6 * 6 + k / 6]));
        assert!(rows.iter().any(|entry| *entry != 0.0));
    }

    #[test]
    fn blocks_that_do_not_fit_are_refused() {
        let wrong = BlockSparse::new(Partition::new(&[2]), &[SparseBlock::new(0, 0, &[1.0; 3])]);
        assert!(matches!(wrong, Err(SolveError::DimensionMismatch { expected: 4, found: 3, .. })));
        let wrong = BlockSparse::new(Partition::new(&[1]), &[SparseBlock::new(0, 0, &[f64::NAN])]);
        assert!(matches!(wrong, Err(SolveError::NonFinite { .. })));
    }
}
