//! Conversions of coefficients between orthonormal Jacobi and Legendre polynomials.

use pyo3::prelude::*;
use radiosity_core::convert;

use super::{Output, misfit, work};

/// Turns rows of `length` Jacobi coefficients into Legendre coefficients, in place.
#[pyfunction]
pub(super) fn to_legendre(
    py: Python<'_>,
    alpha: u8,
    beta: u8,
    length: usize,
    rows: Output<'_>,
) -> PyResult<()> {
    convert(py, length, rows, |row| convert::to_legendre(alpha, beta, row))
}

/// Turns rows of `length` Legendre coefficients into Jacobi coefficients, in place.
#[pyfunction]
pub(super) fn from_legendre(
    py: Python<'_>,
    alpha: u8,
    beta: u8,
    length: usize,
    rows: Output<'_>,
) -> PyResult<()> {
    convert(py, length, rows, |row| convert::from_legendre(alpha, beta, row))
}

fn convert(
    py: Python<'_>,
    length: usize,
    mut rows: Output<'_>,
    turn: impl Fn(&mut [f64]) + Send,
) -> PyResult<()> {
    let numbers = rows.as_slice_mut()?;
    if length == 0 || !numbers.len().is_multiple_of(length) {
        return Err(misfit("whole rows of coefficients are wanted"));
    }
    work(py, numbers.len(), || numbers.chunks_exact_mut(length).for_each(turn));
    Ok(())
}
