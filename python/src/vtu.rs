//! Solutions as grids of VTK.

use pyo3::prelude::*;
use pyo3::types::PyBytes;
use radiosity::output::vtu::Grid;

use crate::error::Trouble;
use crate::solution::Solution;

/// The bytes of a `.vtu` file: cells of Lagrange polynomials that hold the light itself.
#[pyfunction]
pub(crate) fn vtu<'py>(py: Python<'py>, solution: &Solution) -> PyResult<Bound<'py, PyBytes>> {
    let solved = &solution.solved;
    let bytes = py.detach(|| {
        let mut bytes = Vec::new();
        Grid::new(&solved.scene, &solved.outcome.solution)
            .map_err(|error| {
                Trouble::new(error.to_string(), "solve without shadow masks, at an order of 20 at the most")
            })?
            .write(&mut bytes)
            .map_err(|error| Trouble::new(error.to_string(), "free some memory"))?;
        Ok::<_, Trouble>(bytes)
    })?;
    Ok(PyBytes::new(py, &bytes))
}
