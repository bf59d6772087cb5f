//! The matrix as solvers use it.

use crate::partition::Partition;

/// A real square matrix A, cut into blocks, known by its products with vectors.
///
/// Every vector is a plain slice; a whole one has `partition().dim()` entries, a block one
/// `partition().size(block)`. Several right-hand sides lie one after the other: entry `i` of column `c` is
/// `x[c·dim + i]`. An implementation must write every entry of a product, a row or a diagonal block: entries
/// left out are found and refused as [`NonFinite`](crate::SolveError::NonFinite).
pub trait Operator: Sync {
    /// The blocks of rows, and of columns.
    fn partition(&self) -> &Partition;

    /// One block row: y = (A x) on the rows of block `row`; `x` is whole, `y` a block. Provided by the whole
    /// product.
    fn gather(&self, row: usize, x: &[f64], y: &mut [f64]) {
        let mut all = vec![0.0; x.len()];
        self.apply(x, &mut all);
        y.copy_from_slice(&all[self.partition().range(row)]);
    }

    /// One block column: y += A\[:, column\] x; `x` is a block, `y` whole. A greedy solver uses the matrix
    /// only through this and [`diagonal`](Self::diagonal): an implementation may compute the column when it
    /// is first shot.
    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]);

    /// y = A x; provided by shooting every column.
    fn apply(&self, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        for column in 0..self.partition().len() {
            self.shoot(column, &x[self.partition().range(column)], y);
        }
    }

    /// The square diagonal block of `block`, column by column: entry (k, l) at `out[l·size + k]`.
    ///
    /// Provided by shooting each unit vector of the block, which makes a whole block column of `dim·size`
    /// entries to keep `size²` of them, and computes it where columns are computed on demand. Write it
    /// yourself wherever the diagonal block is known by itself: jacobi, gauss-seidel, southwell and the
    /// preconditioners of cg and gmres read it of every block that they touch.
    fn diagonal(&self, block: usize, out: &mut [f64]) {
        let range = self.partition().range(block);
        let (dim, size) = (self.partition().dim(), range.len());
        let mut columns = vec![0.0; dim * size];
        self.entries(block, &mut columns);
        for l in 0..size {
            out[l * size..][..size].copy_from_slice(&columns[l * dim..][range.clone()]);
        }
    }

    /// Whether A = Aᵀ up to rounding. A wrong yes costs time, never a wrong answer.
    fn symmetric(&self) -> bool {
        false
    }

    /// All entries, column by column, (i, j) at `[j·dim + i]`, of an operator that holds them so: direct
    /// methods then copy what they need in one go.
    fn dense(&self) -> Option<&[f64]> {
        None
    }

    /// Y = A X for several vectors at once; both of length `k·dim`. It may differ from [`apply`](Self::apply) by
    /// rounding.
    fn apply_many(&self, x: &[f64], y: &mut [f64]) {
        let dim = self.partition().dim().max(1);
        for (x, y) in x.chunks_exact(dim).zip(y.chunks_exact_mut(dim)) {
            self.apply(x, y);
        }
    }

    /// The entries of block column `column`, for direct methods: (i, l) at `out[l·dim + i]`; provided by
    /// shooting unit vectors.
    fn entries(&self, column: usize, out: &mut [f64]) {
        let mut unit = vec![0.0; self.partition().size(column)];
        out.fill(0.0);
        for (l, out) in out.chunks_exact_mut(self.partition().dim().max(1)).enumerate() {
            unit[l] = 1.0;
            self.shoot(column, &unit, out);
            unit[l] = 0.0;
        }
    }
}
