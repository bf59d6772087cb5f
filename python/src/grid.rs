//! Means over the cells of surfaces.

use numpy::PyArrayDyn;
use pyo3::prelude::*;
use radiosity::geom::DVec3;
use radiosity::reading::grid::Cell;
use radiosity::scene::Scene;

use crate::arrays::array;
use crate::checked;
use crate::told::Told;

/// Means over the cells of every surface.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Grid {
    told: Told<Cell>,
    bands: usize,
    /// Middle of the scene, which positions of cells are relative to (length).
    middle: DVec3,
}

impl Grid {
    pub(crate) fn new(told: Told<Cell>, scene: &Scene) -> Self {
        Self { told, bands: scene.bands.len(), middle: scene.middle }
    }

    fn cells(&self) -> &[Cell] {
        &self.told.readings
    }

    fn of_bands<'py>(&self, py: Python<'py>, of: impl Fn(&Cell) -> &[f64]) -> Bound<'py, PyArrayDyn<f64>> {
        let numbers = self.cells().iter().flat_map(|cell| of(cell).iter().copied()).collect();
        array(py, &[self.cells().len(), self.bands], numbers)
    }
}

#[pymethods]
impl Grid {
    /// Index of the surface of each cell.
    #[getter]
    fn surface(&self) -> Vec<usize> {
        self.cells().iter().map(|cell| cell.surface).collect()
    }

    /// Place of each cell along u and v.
    #[getter]
    fn index(&self) -> Vec<[usize; 2]> {
        self.cells().iter().map(|cell| cell.index).collect()
    }

    #[getter]
    fn irradiance<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_bands(py, |cell| &cell.irradiance)
    }

    #[getter]
    fn radiosity<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.of_bands(py, |cell| &cell.radiosity)
    }

    /// The error that is told of each irradiance: an array (n,).
    #[getter]
    fn errors<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        array(py, &[self.cells().len()], self.told.errors.clone())
    }

    /// JSON of what a referee found; None where it did not look.
    #[getter]
    fn checked(&self) -> Option<String> {
        checked::json(self.told.checked.as_ref())
    }

    #[getter]
    fn area<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        array(py, &[self.cells().len()], self.cells().iter().map(|cell| cell.area).collect())
    }

    /// The middle of each cell: an array (n, 3).
    #[getter]
    fn position<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let numbers = self.cells().iter().flat_map(|cell| (cell.position + self.middle).to_array());
        array(py, &[self.cells().len(), 3], numbers.collect())
    }
}
