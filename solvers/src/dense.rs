//! A matrix held entry by entry.
//!
//! Columns follow each other, so that a block column is one slice and y = A x is a sum of columns,
//!
//!   y_i = Σ_j a_ij x_j.
//!
//! Every y_i is summed over j in ascending order, four columns at a time, whatever rows a thread is
//! given: the number of threads never changes a bit.

mod conversions;

use rayon::prelude::*;

use crate::error::SolveError;
use crate::operator::Operator;
use crate::partition::Partition;
use crate::tolerances::ASYMMETRY_OF_ENTRIES;
use crate::vector::{add_scaled, all_finite, dot};

/// Rows summed together: 8 kB of partial sums, which stay in the first-level cache.
const ROWS: usize = 1024;

/// A real square matrix held entry by entry, finite, cut into blocks.
///
/// ```
/// use radiosity_solvers::{Dense, Partition, Settings, method::Method};
///
/// // Two blocks of one unknown each: 4x + y = 1, x + 3y = 2.
/// let a = Dense::new(Partition::points(2), vec![4.0, 1.0, 1.0, 3.0], true)?;
/// let mut x = [0.0; 2];
/// let report = Method::named("cg")?.solver.solve(&a, &[1.0, 2.0], &mut x, &Settings::default(), &mut |_| ())?;
/// assert!(report.residual <= 1e-8);
/// assert!((x[0] - 1.0 / 11.0).abs() < 1e-7 && (x[1] - 7.0 / 11.0).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Matrices of [faer] and [nalgebra] are taken by `try_from`, as blocks of one unknown ([`with_partition`]
/// cuts other ones), and a `Dense` is seen as theirs by `from`, without a copy:
///
/// ```
/// use radiosity_solvers::{Dense, Partition};
///
/// let a = Dense::try_from(nalgebra::DMatrix::from_row_slice(2, 2, &[4.0, 1.0, 1.0, 3.0]))?;
/// let a = a.with_partition(Partition::new(&[2]))?;
/// assert_eq!(faer::MatRef::from(&a)[(1, 1)], 3.0);
/// # Ok::<(), radiosity_solvers::SolveError>(())
/// ```
///
/// [`with_partition`]: Self::with_partition
#[derive(Clone, Debug)]
pub struct Dense {
    partition: Partition,
    /// Entry (i, j) at `values[j·dim + i]`.
    values: Vec<f64>,
    symmetric: bool,
    threads: usize,
}

impl Dense {
    /// A matrix from its entries, column by column: (i, j) at `values[j·dim + i]`.
    ///
    /// # Errors
    /// [`DimensionMismatch`](SolveError::DimensionMismatch) unless there are dim² entries,
    /// [`NonFinite`](SolveError::NonFinite) if one is infinite or NaN,
    /// [`NotSymmetric`](SolveError::NotSymmetric) if `symmetric` is claimed and |a_ij − a_ji| > 10⁻¹²
    /// max(|a_ij|, √|a_ii a_jj|) somewhere.
    pub fn new(partition: Partition, values: Vec<f64>, symmetric: bool) -> Result<Self, SolveError> {
        let dim = partition.dim();
        if values.len() != dim * dim {
            return Err(SolveError::DimensionMismatch {
                what: "the matrix",
                expected: dim * dim,
                found: values.len(),
            });
        }
        if !all_finite(&values) {
            return Err(SolveError::NonFinite { what: "the matrix" });
        }
        if symmetric && !is_symmetric(&values, dim) {
            return Err(SolveError::NotSymmetric { method: "the symmetric form of Dense" });
        }
        Ok(Self { partition, values, symmetric, threads: 1 })
    }

    /// Lets products with the whole matrix use up to `threads` threads of the current rayon pool.
    #[must_use]
    pub fn with_threads(self, threads: usize) -> Self {
        Self { threads: threads.max(1), ..self }
    }

    /// The matrix cut into the blocks of `partition`.
    ///
    /// # Errors
    /// [`DimensionMismatch`](SolveError::DimensionMismatch) unless they hold as many unknowns.
    pub fn with_partition(self, partition: Partition) -> Result<Self, SolveError> {
        let (expected, found) = (self.dim(), partition.dim());
        if expected != found {
            return Err(SolveError::DimensionMismatch { what: "the partition", expected, found });
        }
        Ok(Self { partition, ..self })
    }

    /// Number of unknowns.
    fn dim(&self) -> usize {
        self.partition.dim()
    }

    /// The entries, column by column.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Column `j`, whole.
    fn column(&self, j: usize) -> &[f64] {
        let dim = self.partition.dim();
        &self.values[j * dim..][..dim]
    }

    /// y_i = Σ_j a_ij x_j for the rows from `first` on, as many as `y` has.
    fn rows(&self, first: usize, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        let rows = first..first + y.len();
        let (fours, rest) = x.as_chunks::<4>();
        for (four, x) in fours.iter().enumerate() {
            let [a, b, c, d] = std::array::from_fn(|lane| &self.column(4 * four + lane)[rows.clone()]);
            for ((((y, a), b), c), d) in y.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                *y += (a * x[0] + b * x[1]) + (c * x[2] + d * x[3]);
            }
        }
        for (j, x) in (4 * fours.len()..).zip(rest) {
            add_scaled(*x, &self.column(j)[rows.clone()], y);
        }
    }
}

impl Operator for Dense {
    fn partition(&self) -> &Partition {
        &self.partition
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        if self.threads == 1 {
            for (tile, y) in y.chunks_mut(ROWS).enumerate() {
                self.rows(tile * ROWS, x, y);
            }
            return;
        }
        let rows = ROWS.min(y.len().div_ceil(self.threads)).max(1);
        y.par_chunks_mut(rows).enumerate().for_each(|(tile, y)| self.rows(tile * rows, x, y));
    }

    fn gather(&self, row: usize, x: &[f64], y: &mut [f64]) {
        let range = self.partition.range(row);
        if self.symmetric {
            // Row i is column i, and a column is contiguous.
            for (y, i) in y.iter_mut().zip(range) {
                *y = dot(self.column(i), x);
            }
        } else {
            self.rows(range.start, x, y);
        }
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        for (j, x) in self.partition.range(column).zip(x) {
            if *x != 0.0 {
                add_scaled(*x, self.column(j), y);
            }
        }
    }

    fn diagonal(&self, block: usize, out: &mut [f64]) {
        let range = self.partition.range(block);
        for (j, out) in range.clone().zip(out.chunks_exact_mut(range.len().max(1))) {
            out.copy_from_slice(&self.column(j)[range.clone()]);
        }
    }

    fn symmetric(&self) -> bool {
        self.symmetric
    }

    fn dense(&self) -> Option<&[f64]> {
        Some(&self.values)
    }
}

/// Whether a_ij and a_ji differ by rounding only, tile by tile so that both stay in cache.
fn is_symmetric(values: &[f64], dim: usize) -> bool {
    // Two tiles take 16 kB, half of a usual first-level cache.
    const TILE: usize = 32;
    let entry = |i: usize, j: usize| values[j * dim + i];
    let agree = |i, j| {
        let scale = entry(i, j).abs().max((entry(i, i).abs().sqrt()) * entry(j, j).abs().sqrt());
        (entry(i, j) - entry(j, i)).abs() <= ASYMMETRY_OF_ENTRIES * scale
    };
    let tile = |first: usize| first..dim.min(first + TILE);
    (0..dim)
        .step_by(TILE)
        .all(|left| (left..dim).step_by(TILE).all(|top| tile(left).all(|j| tile(top).all(|i| agree(i, j)))))
}
