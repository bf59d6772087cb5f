//! View factors of scenes and of polygons.

use numpy::{IntoPyArray, PyArray1, PyArrayDyn, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::geom::shapes::Polygon;
use radiosity::output::missed::missed;
use radiosity::request::TransferRequest;
use radiosity::scene::{Material, Scene as Whole};
use radiosity::transport::Miss;
use radiosity::{SceneBuilder, view_factors as library};

use crate::arguments::Arguments;
use crate::arrays::{array, points};
use crate::error::{Trouble, warn};
use crate::requests;
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
    given: &Bound<'_, PyDict>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<ViewFactors> {
    factors(py, &scene.scene, &|_, _| true, given, observer.as_ref())
}

/// The view factors between polygons, each an array (k, 3) of its vertices; of the pair (0, 1) alone where that is `single`.
#[pyfunction]
pub(crate) fn view_factors_of_polygons(
    py: Python<'_>,
    polygons: Vec<PyReadonlyArray2<'_, f64>>,
    single: bool,
    given: &Bound<'_, PyDict>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<ViewFactors> {
    let wanted = |i, j| !single || [i, j] == [0, 1];
    factors(py, &scene_of(&polygons)?, &wanted, given, observer.as_ref())
}

fn scene_of(polygons: &[PyReadonlyArray2<'_, f64>]) -> Result<Whole, Trouble> {
    let mut scene = SceneBuilder::new("polygons", ["grey"]);
    let bare = scene.material("bare", Material::black(1));
    for (index, vertices) in polygons.iter().enumerate() {
        let name = format!("surface-{}", index + 1);
        let vertices = points(&format!("polygons[{index}]"), vertices)?;
        let shape = Polygon::new(vertices, Vec::new());
        let shape = shape.map_err(|error| {
            let cure =
                "give the vertices of a flat polygon in order, counterclockwise as seen from its front";
            Trouble::new(format!("polygons[{index}]: {error}"), cure)
        })?;
        scene.surface(name, shape, &bare);
    }
    Ok(scene.build()?)
}

fn factors(
    py: Python<'_>,
    scene: &Whole,
    wanted: &(dyn Fn(usize, usize) -> bool + Sync),
    given: &Bound<'_, PyDict>,
    observer: Option<&Bound<'_, PyAny>>,
) -> PyResult<ViewFactors> {
    let mut given = Arguments::of(given)?;
    let request = requests::transfers(&mut given, TransferRequest::FACTORS)?;
    given.finish("view_factors")?;
    request.check().map_err(Trouble::from)?;
    let factors = work(py, observer, |progress| {
        let tell = |done, total| progress.step("pairs", done, total);
        library::ViewFactors::of_pairs(scene, wanted, &request.factors(), &tell)
    })?;
    if let Some(miss) = factors.miss.filter(Miss::is_real) {
        warn(py, &missed(&miss, miss.pair.map(|surface| &factors.names[surface][..])))?;
    }
    Ok(ViewFactors { factors })
}

#[pymethods]
impl ViewFactors {
    /// F_ij, an array (n, n).
    fn dense<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let count = self.factors.names.len();
        let mut numbers = vec![0.0; count * count];
        for i in 0..count {
            self.factors.nonzeros(i).for_each(|(j, factor)| numbers[i * count + j] = factor);
        }
        array(py, &[count, count], numbers)
    }

    /// F_ij without its zeros: factors, columns, and where each row begins, as SciPy's CSR has them.
    #[expect(clippy::type_complexity, reason = "three arrays, as SciPy takes them")]
    fn sparse<'py>(
        &self,
        py: Python<'py>,
    ) -> (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i32>>, Bound<'py, PyArray1<i64>>) {
        let (mut factors, mut columns, mut begins) = (Vec::new(), Vec::new(), vec![0]);
        for i in 0..self.factors.names.len() {
            for (j, factor) in self.factors.nonzeros(i) {
                factors.push(factor);
                // Surfaces are numbered by 32 bits.
                columns.push(j as i32);
            }
            begins.push(factors.len() as i64);
        }
        (factors.into_pyarray(py), columns.into_pyarray(py), begins.into_pyarray(py))
    }

    /// F from one surface to another.
    fn factor(&self, i: usize, j: usize) -> f64 {
        self.factors.factor(i, j)
    }

    #[getter]
    fn names(&self) -> Vec<String> {
        self.factors.names.clone()
    }

    #[getter]
    fn areas<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        array(py, &[self.factors.areas.len()], self.factors.areas.clone())
    }

    #[getter]
    fn row_sums<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let sums = self.factors.row_sums();
        array(py, &[sums.len()], sums)
    }

    /// Largest error left in the exchange of two elements, and the largest difference of A_i F_ij and A_j F_ji.
    #[getter]
    fn errors(&self) -> [f64; 2] {
        [self.factors.accuracy_reached, self.factors.reciprocity.largest]
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.factors.elapsed.as_secs_f64()
    }
}
