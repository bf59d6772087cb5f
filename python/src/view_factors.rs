//! View factors of scenes and of polygons.

use std::collections::BTreeSet;

use numpy::{IntoPyArray, PyArray1, PyArrayDyn, PyReadonlyArray2, PyReadwriteArray2};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::audit::Checked;
use radiosity::geom::shapes::Polygon;
use radiosity::kernel::WorstError;
use radiosity::reading::accuracy_warning::{missed, missed_by_rays};
use radiosity::reading::checked_factors::CheckedFactors;
use radiosity::reading::row_sums::RowSums;
use radiosity::request::{CheckRequest, TransferRequest};
use radiosity::scene::{Material, Scene as Whole, SceneError};
use radiosity::solve::Failure;
use radiosity::solve::in_threads;
use radiosity::work::{Observer, Progress as Event, Work};
use radiosity::{SceneBuilder, solve::view_factors as library};

use crate::arguments::Arguments;
use crate::arrays::{array, points};
use crate::checked;
use crate::error::{Trouble, warn};
use crate::scene::{Scene, remarks};
use crate::transfers::keeping;
use crate::work::work;

/// View factors between the surfaces of a scene.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct ViewFactors {
    factors: library::ViewFactors,
    told: CheckedFactors,
    /// Pairs of surfaces whose factors were asked for; empty for all.
    pairs: BTreeSet<[usize; 2]>,
    is_closed: Option<bool>,
    remarks: Vec<String>,
}

/// The names of two surfaces.
type Pair = (String, String);

/// Title of a polygon in messages, and its vertices.
type Named<'py> = (String, PyReadonlyArray2<'py, f64>);

/// The view factors between the surfaces of a scene, or those of `pairs` alone, where there are any.
#[pyfunction]
pub(crate) fn view_factors_of_scene(
    py: Python<'_>,
    scene: &Scene,
    pairs: Vec<Pair>,
    given: &Bound<'_, PyDict>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<ViewFactors> {
    factors(py, &scene.scene, &pairs, "view_factors", true, given, observer.as_ref())
}

/// The view factors between polygons, each an array (k, 3) of its vertices, called surface-1 and so on;
/// `function` names the called function in messages, `is_judged` tells whether errors are wanted that walks have
/// judged.
#[pyfunction]
pub(crate) fn view_factors_of_polygons(
    py: Python<'_>,
    polygons: Vec<Named<'_>>,
    pairs: Vec<Pair>,
    function: &str,
    is_judged: bool,
    given: &Bound<'_, PyDict>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<ViewFactors> {
    let scene = scene_of(&polygons)?;
    factors(py, &scene, &pairs, function, is_judged, given, observer.as_ref())
}

fn scene_of(polygons: &[Named<'_>]) -> Result<Whole, Trouble> {
    let mut scene = SceneBuilder::new("polygons", ["grey"]);
    let bare = scene.material("bare", Material::black(1));
    for (index, (what, vertices)) in polygons.iter().enumerate() {
        let name = format!("surface-{}", index + 1);
        let vertices = points(what, vertices)?;
        let shape = Polygon::new(vertices, Vec::new());
        let shape = shape.map_err(|error| {
            let cure =
                "give the vertices of a flat polygon in order, counterclockwise as seen from its front";
            Trouble::new(format!("{what}: {error}"), cure)
        })?;
        scene.surface(name, shape, &bare);
    }
    Ok(scene.build()?)
}

fn factors(
    py: Python<'_>,
    scene: &Whole,
    pairs: &[Pair],
    function: &str,
    is_judged: bool,
    given: &Bound<'_, PyDict>,
    observer: Option<&Bound<'_, PyAny>>,
) -> PyResult<ViewFactors> {
    let mut given = Arguments::of(given)?;
    let request: TransferRequest = given.fields()?;
    let check: CheckRequest = given.fields()?;
    let ranks = keeping(&mut given, scene)?;
    given.finish(function)?;
    let indices = |(one, other): &Pair| Ok([scene.surface_named(one)?, scene.surface_named(other)?]);
    let pairs =
        pairs.iter().map(indices).collect::<Result<BTreeSet<_>, SceneError>>().map_err(Trouble::from)?;
    let wanted = |i, j| pairs.is_empty() || pairs.contains(&[i, j]);
    let options = request.factors().map_err(Trouble::from)?;
    let eps = options.accuracy.eps;
    let from: BTreeSet<usize> = match pairs.is_empty() {
        true => (0..scene.surfaces.len()).collect(),
        false => pairs.iter().map(|pair| pair[0]).collect(),
    };
    let from: Vec<usize> = from.into_iter().collect();
    let (factors, told, sums) = work(py, observer, |progress| {
        let tell = |event| match event {
            Event::Done { done, of, .. } => progress.step("pairs", done, of),
            Event::Rays { .. } => progress.report(event),
            _ => {}
        };
        let work = Work::among(&ranks).observed_by(&tell);
        let factors = library::ViewFactors::of_pairs(scene, &wanted, &options, &work)?;
        let effort = check.of_factors(&factors, &options, from.len(), scene);
        let told = match effort.filter(|_| is_judged || check.audit.is_some()) {
            Some(effort) => in_threads(options.threads, || {
                CheckedFactors::judged(scene, &factors, &from, &wanted, &effort, &Work::alone())
            })?,
            None => CheckedFactors::unjudged(&factors),
        };
        let sums = || RowSums::of(scene, &factors, &options);
        let sums = pairs.is_empty().then(|| in_threads(options.threads, sums)).transpose()?;
        Ok::<_, Failure>((factors, told, sums))
    })?;
    if let Some(worst) = factors.worst_error.filter(WorstError::is_real) {
        warn(py, &missed(&worst, worst.pair.map(|surface| &factors.names[surface][..])))?;
    }
    if let Some(missed) = missed_by_rays(&factors, eps) {
        warn(py, &missed)?;
    }
    if let Some(finding) = told.checked.as_ref().and_then(Checked::finding) {
        warn(py, &format!("walks find the factors off by more than these tell: {finding}").into())?;
    }
    if let Some(warning) = sums.as_ref().and_then(RowSums::warning) {
        warn(py, &warning.message)?;
    }
    let is_closed = sums.and_then(|sums| sums.is_closed());
    Ok(ViewFactors { factors, told, pairs, is_closed, remarks: remarks(scene) })
}

#[pymethods]
impl ViewFactors {
    /// Writes F_ij into an array (n, n) of zeros; factors that were not asked for are no numbers.
    fn fill(&self, mut matrix: PyReadwriteArray2<'_, f64>) {
        let mut matrix = matrix.as_array_mut();
        if self.is_partial() {
            matrix.fill(f64::NAN);
            self.pairs.iter().for_each(|pair| matrix[*pair] = self.factors.factor(pair[0], pair[1]));
            return;
        }
        for (i, row) in self.factors.sparse_rows().enumerate() {
            row.into_iter().for_each(|(j, factor)| matrix[[i, j]] = factor);
        }
    }

    /// Whether the factors of some pairs only were asked for.
    #[getter]
    fn is_partial(&self) -> bool {
        !self.pairs.is_empty()
    }

    /// Whether all radiation that leaves a surface reaches another one; None where that is not known.
    #[getter]
    fn is_closed(&self) -> Option<bool> {
        self.is_closed
    }

    /// Remarks on the reading of the scene.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.remarks.clone()
    }

    /// F_ij without its zeros: factors, columns, and where each row begins, as SciPy's CSR has them.
    #[expect(clippy::type_complexity, reason = "three arrays, as SciPy takes them")]
    fn sparse<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i32>>, Bound<'py, PyArray1<i64>>)> {
        let count = self.factors.sparse_rows().map(|row| row.len()).sum();
        let (mut factors, mut columns, mut begins) = (Vec::new(), Vec::new(), vec![0]);
        let reserved = factors.try_reserve_exact(count).and_then(|()| columns.try_reserve_exact(count));
        reserved.map_err(|error| PyMemoryError::new_err(error.to_string()))?;
        for row in self.factors.sparse_rows() {
            for (j, factor) in row {
                factors.push(factor);
                // Surfaces are numbered by 32 bits.
                columns.push(j as i32);
            }
            begins.push(factors.len() as i64);
        }
        Ok((factors.into_pyarray(py), columns.into_pyarray(py), begins.into_pyarray(py)))
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

    /// The largest error of a factor in the row of each surface.
    #[getter]
    fn errors<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        array(py, &[self.told.errors.len()], self.told.errors.clone())
    }

    /// The largest error of a factor.
    #[getter]
    fn accuracy_reached(&self) -> f64 {
        self.told.largest()
    }

    /// JSON of what walks found; None where they did not look.
    #[getter]
    fn checked(&self) -> Option<String> {
        checked::json(self.told.checked.as_ref())
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.factors.elapsed.as_secs_f64()
    }
}
