//! Columns of tables and of row-major matrices.

use radiosity_core::dot;

/// Adds `factor` times `column` to `out`.
pub fn add_scaled(out: &mut [f64], factor: f64, column: &[f64]) {
    out.iter_mut().zip(column).for_each(|(o, x)| *o += factor * x);
}

/// Subtracts the projection on the unit column `unit` from `column`; returns the inner product.
pub fn take_out(column: &mut [f64], unit: &[f64]) -> f64 {
    let overlap = dot(column, unit);
    add_scaled(column, -overlap, unit);
    overlap
}

/// The transpose of a row-major matrix of so many columns.
pub fn transposed(matrix: &[f64], columns: usize) -> Vec<f64> {
    (0..columns).flat_map(|column| matrix.iter().skip(column).step_by(columns).copied()).collect()
}
