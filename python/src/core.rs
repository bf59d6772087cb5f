//! The private module `_core`: Gauss rules, polynomials and conversions of `radiosity-core` on flat arrays.
//!
//! `radiosity/core.py` checks what the user gives, makes every array and states shapes and domains; here
//! arrays are contiguous and results are written into them, so that NumPy alone allocates and a lack of
//! memory is a `MemoryError`.

mod bases;
mod conversions;
mod family;
mod polynomials;
mod rules;

use std::ops::Range;

use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use radiosity_core::jacobi::Weight;

/// Fewer numbers than this are written without letting other threads of Python run: that costs more than it
/// gives.
const FEW: usize = 4096;

/// Gauss rules, polynomials and conversions on flat arrays.
#[pymodule]
pub(crate) mod _core {
    #[pymodule_export]
    use super::bases::{square_basis, triangle_basis, triangle_rule};
    #[pymodule_export]
    use super::conversions::convert;
    #[pymodule_export]
    use super::polynomials::{classical, legendre_sum, orthonormal};
    #[pymodule_export]
    use super::rules::{asymptotic_rule, integral, jacobi_rule, legendre_rule};
}

/// Numbers that come in.
type Input<'py> = PyReadonlyArray1<'py, f64>;

/// Place for numbers that go out.
type Output<'py> = PyReadwriteArray1<'py, f64>;

/// Steps that are done before signals are looked for: some hundredths of a second. Chosen.
const AT_ONCE: usize = 1 << 23;

/// Runs the work, beside other threads of Python where it takes many steps.
fn work<T: Send>(py: Python<'_>, steps: usize, task: impl FnOnce() -> T + Send) -> T {
    if steps < FEW { task() } else { py.detach(task) }
}

/// Runs the work on so many rows that take so many steps each, some of them at a time.
///
/// # Errors
/// The exception that a handler of signals raises between two pieces.
fn by_rows(
    py: Python<'_>,
    rows: usize,
    steps: usize,
    mut task: impl FnMut(Range<usize>) + Send,
) -> PyResult<()> {
    let at_once = (AT_ONCE / steps.max(1)).max(1);
    for first in (0..rows).step_by(at_once) {
        let some = first..rows.min(first.saturating_add(at_once));
        work(py, some.len().saturating_mul(steps), || task(some));
        py.check_signals()?;
    }
    Ok(())
}

/// The weight (1 − x)^α (1 + x)^β.
fn weight(alpha: f64, beta: f64) -> PyResult<Weight> {
    Weight::new(alpha, beta).map_err(refused)
}

/// The exception for an error of `radiosity-core`.
fn refused(error: impl std::error::Error) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// Arrays that do not fit each other; `radiosity/core.py` makes none.
fn misfit(wanted: &str) -> PyErr {
    PyValueError::new_err(format!("the arrays do not fit each other: {wanted}"))
}
