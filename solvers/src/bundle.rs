//! Columns that pass the kernels together, always as many: a matrix is read once for all of them.
//!
//! The entries of a row lie beside each other, so that a register holds those of several columns and each column
//! is summed in its own lane. faer chooses its kernels, and with them the order of sums, by the shape of a product:
//! columns that are not asked for are 0, and the shape is the same. So a column has the same bits alone, among
//! others, and in any place.
//!
//! With panels L_pp on the diagonal of a lower triangle L and L_qp below them,
//!
//!   L X = B:    X_p = L_pp⁻¹ B_p,   B_q ← B_q − L_qp X_p,
//!   Lᵀ X = B:   X_p = L_pp⁻ᵀ (B_p − L_qpᵀ X_q).

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

/// Columns of a bundle: those of faer's widest kernel on registers of 512 bits; 24 or 32 take as long. A column alone
/// takes some three times as long as its matrix takes to be read, little beside the factors.
pub(crate) const COLUMNS: usize = 48;

/// Rows of a panel: within it the triangle is solved entry by entry. Chosen.
const PANEL: usize = 48;

/// Entries of a row.
type Row = [f64; COLUMNS];

/// Up to [`COLUMNS`] columns of the same length; the others are 0.
pub(crate) struct Bundle {
    rows: Vec<Row>,
}

impl Bundle {
    /// Some columns of `dim` entries, which lie one after the other.
    pub(crate) fn of(columns: &[f64], dim: usize) -> Self {
        let mut rows = vec![[0.0; COLUMNS]; dim];
        for (lane, column) in columns.chunks_exact(dim.max(1)).enumerate() {
            rows.iter_mut().zip(column).for_each(|(row, entry)| row[lane] = *entry);
        }
        Self { rows }
    }

    /// Writes its first columns one after the other.
    pub(crate) fn write(&self, columns: &mut [f64]) {
        for (lane, column) in columns.chunks_exact_mut(self.rows.len().max(1)).enumerate() {
            column.iter_mut().zip(&self.rows).for_each(|(entry, row)| *entry = row[lane]);
        }
    }

    /// X := L⁻¹ X for the lower triangle L of a matrix.
    pub(crate) fn solve_lower(&mut self, matrix: MatRef<'_, f64>) {
        let dim = self.rows.len();
        for start in (0..dim).step_by(PANEL) {
            let end = dim.min(start + PANEL);
            let (solved, below) = self.rows[start..].split_at_mut(end - start);
            for k in 0..solved.len() {
                let (known, rest) = solved.split_at_mut(k + 1);
                let known = &mut known[k];
                known.iter_mut().for_each(|x| *x /= matrix[(start + k, start + k)]);
                for (i, row) in (start + k + 1..).zip(rest) {
                    subtract(matrix[(i, start + k)], known, row);
                }
            }
            let panel = matrix.get(end.., start..end);
            matmul(matrix_mut(below), Accum::Add, panel, matrix_of(solved), -1.0, Par::Seq);
        }
    }

    /// X := L⁻ᵀ X for the lower triangle L of a matrix.
    pub(crate) fn solve_transposed(&mut self, matrix: MatRef<'_, f64>) {
        let dim = self.rows.len();
        for start in (0..dim).step_by(PANEL).rev() {
            let end = dim.min(start + PANEL);
            let (own, below) = self.rows[start..].split_at_mut(end - start);
            let panel = matrix.get(end.., start..end).transpose();
            matmul(matrix_mut(own), Accum::Add, panel, matrix_of(below), -1.0, Par::Seq);
            for k in (0..own.len()).rev() {
                let (rest, known) = own.split_at_mut(k);
                let known = &mut known[0];
                known.iter_mut().for_each(|x| *x /= matrix[(start + k, start + k)]);
                for (i, row) in (start..).zip(rest) {
                    subtract(matrix[(start + k, i)], known, row);
                }
            }
        }
    }
}

/// y ← y − a x.
fn subtract(a: f64, x: &Row, y: &mut Row) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y -= a * x);
}

fn matrix_of(rows: &[Row]) -> MatRef<'_, f64> {
    MatRef::from_row_major_slice(rows.as_flattened(), rows.len(), COLUMNS)
}

fn matrix_mut(rows: &mut [Row]) -> MatMut<'_, f64> {
    let count = rows.len();
    MatMut::from_row_major_slice_mut(rows.as_flattened_mut(), count, COLUMNS)
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIMS: [usize; 8] = [1, 3, 17, 48, 49, 97, 200, 517];

    fn number(k: usize) -> f64 {
        (k * 7919 % 1009) as f64 / 500.0 - 1.0
    }

    /// Entries with 4 on the diagonal, column by column, and columns.
    fn given(dim: usize, columns: usize) -> (Vec<f64>, Vec<f64>) {
        let entry = |k: usize| if k % dim == k / dim { 4.0 } else { number(k) / dim as f64 };
        let column = |c: usize| (0..dim).map(move |i| number(31 * c + i));
        ((0..dim * dim).map(entry).collect(), (0..columns).flat_map(column).collect())
    }

    /// The results of the columns in one bundle.
    fn of_bundle(dim: usize, columns: &[f64], pass: &dyn Fn(&mut Bundle)) -> Vec<f64> {
        let mut bundle = Bundle::of(columns, dim);
        pass(&mut bundle);
        let mut results = vec![f64::NAN; columns.len()];
        bundle.write(&mut results);
        results
    }

    #[test]
    fn solutions_are_those_of_the_triangle() {
        for dim in DIMS {
            let (entries, columns) = given(dim, 5);
            let matrix = MatRef::from_column_major_slice(&entries, dim, dim);
            let lower = of_bundle(dim, &columns, &|own| own.solve_lower(matrix));
            let transposed = of_bundle(dim, &columns, &|own| own.solve_transposed(matrix));
            for c in 0..5 {
                let column = c * dim..(c + 1) * dim;
                let [b, x, y] = [&columns, &lower, &transposed].map(|all| &all[column.clone()]);
                let sum =
                    |of: &dyn Fn(usize) -> f64, range: std::ops::Range<usize>| range.map(of).sum::<f64>();
                for i in 0..dim {
                    let near =
                        |found: f64, right: f64| assert!((found - right).abs() < 1e-12, "{found} {right}");
                    near(sum(&|j| entries[j * dim + i] * x[j], 0..i + 1), b[i]);
                    near(sum(&|j| entries[i * dim + j] * y[j], i..dim), b[i]);
                }
            }
        }
    }

    #[test]
    fn a_column_has_the_same_bits_in_any_place_and_company() {
        for dim in DIMS {
            let (entries, columns) = given(dim, COLUMNS);
            let matrix = MatRef::from_column_major_slice(&entries, dim, dim);
            let pass = |own: &mut Bundle| {
                own.solve_lower(matrix);
                own.solve_transposed(matrix);
            };
            let together = of_bundle(dim, &columns, &pass);
            for (alone, together) in columns.chunks_exact(dim).zip(together.chunks_exact(dim)) {
                assert_eq!(of_bundle(dim, alone, &pass), together, "{dim}");
            }
        }
    }
}
