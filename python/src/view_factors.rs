//! View factors of scenes and of polygons.

use numpy::PyArrayDyn;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use radiosity::geom::shapes::Polygon;
use radiosity::scene::{Material, Scene as Whole};
use radiosity::transport::Accuracy;
use radiosity::visibility::Hiding;
use radiosity::{SceneBuilder, view_factors as library};

use crate::arrays::{array, points};
use crate::error::Trouble;
use crate::scene::Scene;
use crate::work::work;

/// View factors between the surfaces of a scene.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct ViewFactors {
    factors: library::ViewFactors,
}

/// The view factors between the surfaces of a scene.
#[pyfunction]
pub(crate) fn view_factors_of_scene(
    py: Python<'_>,
    scene: &Scene,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<ViewFactors> {
    factors(py, &scene.scene, observer.as_ref())
}

/// The view factors between polygons, each an array (k, 3) of its vertices.
#[pyfunction]
pub(crate) fn view_factors_of_polygons(
    py: Python<'_>,
    polygons: Vec<PyReadonlyArray2<'_, f64>>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<ViewFactors> {
    factors(py, &scene_of(&polygons)?, observer.as_ref())
}

fn scene_of(polygons: &[PyReadonlyArray2<'_, f64>]) -> Result<Whole, Trouble> {
    let mut scene = SceneBuilder::new("polygons", ["grey"]);
    let bare = scene.material("bare", Material::black(1));
    for (index, vertices) in polygons.iter().enumerate() {
        let name = format!("polygons[{index}]");
        let shape = Polygon::new(points(&name, vertices)?, Vec::new());
        let shape = shape.map_err(|error| Trouble::new(format!("{name}: {error}"), ""))?;
        scene.surface(name, shape, &bare);
    }
    Ok(scene.build()?)
}

fn factors(py: Python<'_>, scene: &Whole, observer: Option<&Bound<'_, PyAny>>) -> PyResult<ViewFactors> {
    let accuracy = Accuracy { eps: 1e-3, shadow_eps: 1e-3 };
    let threads = radiosity::Options::default().threads;
    let options = library::Options { subdivide: None, accuracy, shadows: Hiding::Auto, threads };
    let factors = work(py, observer, |progress| {
        library::ViewFactors::new(scene, &options, &|done, total| progress.step("pairs", done, total))
    })?;
    Ok(ViewFactors { factors })
}

#[pymethods]
impl ViewFactors {
    /// F_ij, an array (n, n).
    #[getter]
    fn matrix<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let count = self.factors.names.len();
        array(py, &[count, count], (0..count).flat_map(|i| self.factors.row(i)).collect())
    }

    /// Names of the surfaces.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.factors.names.clone()
    }

    /// Areas of the surfaces (scene length²).
    #[getter]
    fn areas<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        array(py, &[self.factors.areas.len()], self.factors.areas.clone())
    }

    /// Σ_j F_ij of each surface.
    #[getter]
    fn row_sums<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let sums = self.factors.row_sums();
        array(py, &[sums.len()], sums)
    }
}
