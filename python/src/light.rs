//! Light that is read: at points, on planes, over cells and through cameras.

use std::sync::Arc;

use numpy::{PyArrayDyn, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::probe::{Probe, ProbeReading, probe};
use radiosity::reading::quality::ReadSettings;
use radiosity::reading::read_error::ReadError;
use radiosity::reading::reader::Reader;
use radiosity::request::cells::require_cells;
use radiosity::request::{MethodRequest, ReadRequest, ranges};
use radiosity::scene;
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::solution;
use radiosity::solve::solved::Solved;
use radiosity::solve::{Options, in_threads};
use radiosity::visibility::Visibility;
use radiosity::work::Work;
use radiosity::work::ranks::Ranks;

use crate::arguments::Arguments;
use crate::arrays::{array, probes, relative};
use crate::error::{Trouble, warn};
use crate::grid::Grid;
use crate::picture;
use crate::plane::{self, Plane};
use crate::progress::Progress;
use crate::scene::Scene;
use crate::work::work;

/// The light of a scene.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Light {
    found: Found,
    options: Options,
    /// Method of the light; the usual one where it was read from a file.
    method: MethodRequest,
}

/// Where light was found.
pub(crate) enum Found {
    /// In a scene by itself, or in a file.
    Solved { solved: Arc<Solved>, is_saved: bool },
    /// In a frame.
    Frame(Box<Frame>),
}

impl Found {
    fn scene(&self) -> &scene::Scene {
        match self {
            Self::Solved { solved, .. } => &solved.scene,
            Self::Frame(frame) => &frame.scene,
        }
    }

    fn solution(&self) -> &solution::Solution {
        match self {
            Self::Solved { solved, .. } => &solved.outcome.solution,
            Self::Frame(frame) => &frame.solution,
        }
    }

    fn visibility(&self) -> &Visibility {
        match self {
            Self::Solved { solved, .. } => solved.visibility(),
            Self::Frame(frame) => &frame.visibility,
        }
    }

    fn reading(&self, request: &ReadRequest, method: &MethodRequest) -> ReadSettings {
        match self {
            Self::Solved { solved, is_saved } => request.reading(method, solved, *is_saved),
            Self::Frame(_) => request.plain(method),
        }
    }
}

/// Irradiances, and their standard deviations relative to them.
type Readings<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>);

impl Light {
    /// Light that was found by this method, with these options.
    pub(crate) fn new(found: Found, options: Options, method: MethodRequest) -> Self {
        Self { found, options, method }
    }

    /// Reading of the light as `given`, and number of threads.
    fn reading(&self, given: &mut Arguments<'_>, request: ReadRequest) -> PyResult<(ReadSettings, usize)> {
        let threads = given.value("threads")?.map_or(self.options.threads, ranges::Threads::count);
        request.check(&self.options, &self.method).map_err(Trouble::from)?;
        Ok((self.found.reading(&request, &self.method), threads))
    }

    /// Reads the light by so many threads and reports to `observer` how far it is.
    pub(crate) fn read<T: Send>(
        &self,
        py: Python<'_>,
        observer: Option<&Bound<'_, PyAny>>,
        threads: usize,
        read: impl FnOnce(&Progress) -> T + Send,
    ) -> PyResult<T> {
        work(py, observer, |progress| in_threads(threads, || read(progress)))
    }

    /// Readings of sensors as `given`; warns where rays leave more of an error than was asked for.
    fn sense(
        &self,
        py: Python<'_>,
        sensors: &[Probe],
        given: Arguments<'_>,
        function: &str,
        observer: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Vec<ProbeReading>> {
        let mut given = given;
        let request = given.fields()?;
        let (how, threads) = self.reading(&mut given, request)?;
        given.finish(function)?;
        let readings = self.read(py, observer, threads, |progress| {
            let work = Work::alone().observed_by(progress);
            probe(&self.reader(&how), sensors, self.found.scene().middle, &work)
        })?;
        let readings = readings.map_err(|(index, fault)| {
            let cure =
                "the polynomials are known on surfaces alone, along their normals: choose read=\"gather\"";
            Trouble::new(format!("points[{index}]: {fault}"), cure)
        })?;
        warn_of(py, ReadError::of(readings.iter().map(|reading| reading.deviation)), how.eps)?;
        Ok(readings)
    }

    fn reader(&self, how: &ReadSettings) -> Reader<'_> {
        how.reader(self.found.solution(), self.found.visibility())
    }

    fn cells(&self, how: &ReadSettings, sides: [usize; 2], progress: &Progress) -> Vec<Cell> {
        grid(&self.reader(how), sides, how.rates, &Work::alone().observed_by(progress))
    }
}

/// Warns where rays leave more of an error than was asked for.
fn warn_of(py: Python<'_>, error: Option<ReadError>, asked: f64) -> PyResult<()> {
    match error.and_then(|error| error.warning(asked)) {
        Some(warning) => warn(py, &warning.message),
        None => Ok(()),
    }
}

#[pymethods]
impl Light {
    /// Scene of the light.
    #[getter]
    fn scene(&self) -> Scene {
        Scene { scene: self.found.scene().clone() }
    }

    /// Coefficients of the radiosity in the orthonormal bases of the elements: an array (bands, unknowns).
    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let bands = self.found.solution().bands();
        let numbers: Vec<f64> =
            bands.iter().flat_map(|band| band.coefficients.radiosity.iter().copied()).collect();
        array(py, &[bands.len(), numbers.len() / bands.len()], numbers)
    }

    /// The surface of each element, and how many coefficients it has.
    #[getter]
    fn elements(&self) -> Vec<(usize, usize)> {
        let elements = self.found.solution().elements().list();
        elements.iter().map(|element| (element.surface, element.basis.len())).collect()
    }

    /// Irradiance at points (n, 3) for normals (n, 3): an array (n, bands), and its standard deviations
    /// relative to it, (n,), not a number where rays gathered nothing.
    fn irradiance<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'_, f64>,
        normals: PyReadonlyArray2<'_, f64>,
        given: &Bound<'_, PyDict>,
        observer: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Readings<'py>> {
        let sensors = probes(&positions, &normals)?;
        let given = Arguments::of(given)?;
        let readings = self.sense(py, &sensors, given, "irradiance", observer.as_ref())?;
        let errors = readings.iter().map(|reading| relative(reading.deviation)).collect();
        let numbers = readings.into_iter().flat_map(|reading| reading.irradiance).collect();
        let numbers = array(py, &[sensors.len(), self.found.scene().bands.len()], numbers);
        Ok((numbers, array(py, &[sensors.len()], errors)))
    }

    /// Readings of a plane of sensors: one of the scene by its name, or one from a corner along two edges.
    fn plane(
        &self,
        py: Python<'_>,
        plane: plane::Given,
        given: &Bound<'_, PyDict>,
        observer: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Plane> {
        let plane = plane.of(self.found.scene())?;
        let sensors: Vec<Probe> = Probe::of_plane(&plane).collect();
        let readings = self.sense(py, &sensors, Arguments::of(given)?, "plane", observer.as_ref())?;
        let own = Plane::new(plane, self.found.scene(), readings);
        own.warning().map_or(Ok(()), |message| warn(py, &message))?;
        Ok(own)
    }

    /// Means over the cells of every surface.
    fn grid(
        &self,
        py: Python<'_>,
        given: &Bound<'_, PyDict>,
        observer: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Grid> {
        let mut given = Arguments::of(given)?;
        let sides =
            given.pair::<ranges::Pixels>("cells")?.map_or([16, 16], |cells| cells.map(ranges::Pixels::count));
        let memory = given.parsed("memory")?.or(self.method.memory);
        let samples =
            given.pair::<ranges::Samples>("read_samples")?.map(|samples| samples.map(ranges::Samples::count));
        let samples = samples.map(|[direct, indirect]| Rates { direct, indirect });
        let request = ReadRequest { samples, ..given.fields()? };
        let (how, threads) = self.reading(&mut given, request)?;
        given.finish("grid")?;
        let scene = self.found.scene();
        require_cells(sides, scene, memory, Ranks::alone()).map_err(Trouble::from)?;
        let cells =
            self.read(py, observer.as_ref(), threads, |progress| self.cells(&how, sides, progress))?;
        warn_of(py, ReadError::of(cells.iter().map(|cell| cell.deviation)), how.eps)?;
        Ok(Grid::new(cells, scene))
    }

    /// A picture: an array (rows, columns, bands).
    fn render<'py>(
        &self,
        py: Python<'py>,
        camera: Option<picture::Given>,
        given: &Bound<'_, PyDict>,
        observer: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let shot = picture::Shot::of(camera, given, self.found.scene(), &self.options, &self.method)?;
        let raster = self.read(py, observer.as_ref(), shot.threads, |progress| {
            shot.take(self.found.solution(), self.found.visibility(), progress)
        })?;
        let [width, height] = raster.size().map(|pixels| pixels as usize);
        let numbers = raster.pixels().flatten().copied().collect();
        Ok(array(py, &[height, width, self.found.scene().bands.len()], numbers))
    }
}
