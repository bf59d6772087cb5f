//! Solutions: read at points, and written to files.

use numpy::{PyArrayDyn, PyReadonlyArray2};
use pyo3::prelude::*;
use radiosity::output::probe::{Probe, probe};
use radiosity::output::reader::{Read, Reader};
use radiosity::output::solution_file;
use radiosity::scene::{Scene, Source};
use radiosity::solve::in_threads;
use radiosity::solved::Solved;

use crate::arrays::{array, points};
use crate::error::Trouble;
use crate::work::work;

/// A scene with its solution.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Solution {
    pub(crate) solved: Solved,
}

/// The solution in a file.
#[pyfunction]
pub(crate) fn load_solution(path: &str) -> Result<Solution, Trouble> {
    let text: Source = Scene::text_of(path, &[])?;
    Ok(Solution { solved: solution_file::read(&text)? })
}

#[pymethods]
impl Solution {
    /// Irradiance at points (n, 3) for unit normals (n, 3): an array (n, bands).
    fn irradiance<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'_, f64>,
        normals: PyReadonlyArray2<'_, f64>,
        observer: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let (positions, normals) = (points("points", &positions)?, points("normals", &normals)?);
        let probes: Vec<Probe> =
            positions.into_iter().zip(normals).map(|(position, normal)| Probe { position, normal }).collect();
        let Solved { scene, options, outcome, .. } = &self.solved;
        let readings = work(py, observer.as_ref(), |progress| {
            let read = || {
                let reader = Reader::new(&outcome.solution, self.solved.visibility(), Read::Gather, 1.25e-3);
                probe(&reader, &probes, scene.middle, &|done, total| progress.step("points", done, total))
            };
            in_threads(options.threads, read).map_err(Trouble::from)
        })?;
        let readings =
            readings.map_err(|(index, fault)| Trouble::new(format!("points[{index}]: {fault}"), ""))?;
        let numbers = readings.into_iter().flat_map(|reading| reading.irradiance).collect();
        Ok(array(py, &[probes.len(), scene.bands.len()], numbers))
    }
}
