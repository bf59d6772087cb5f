//! Conversions of coefficients between orthonormal Jacobi and Legendre polynomials.

use pyo3::prelude::*;
use radiosity_core::convert::{from_legendre, to_legendre};

use super::{Output, by_rows, misfit};

/// Turns rows of `length` Jacobi coefficients into Legendre coefficients, or `backwards`, in place.
#[pyfunction]
pub(super) fn convert(
    py: Python<'_>,
    alpha: u8,
    beta: u8,
    backwards: bool,
    length: usize,
    mut rows: Output<'_>,
) -> PyResult<()> {
    let numbers = rows.as_slice_mut()?;
    if length == 0 || !numbers.len().is_multiple_of(length) {
        return Err(misfit("whole rows of coefficients are wanted"));
    }
    let turn = if backwards { from_legendre } else { to_legendre };
    by_rows(py, numbers.len() / length, length, |some| {
        let rows = &mut numbers[some.start * length..some.end * length];
        rows.chunks_exact_mut(length).for_each(|row| turn(alpha, beta, row));
    })
}
