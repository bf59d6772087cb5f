//! Solutions: read at points, on planes, over cells and through cameras; dimmed; written.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::sync::{Arc, OnceLock};

use numpy::{PyArrayDyn, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::reading::files::solution_file::{self, SolutionFile, is_solution};
use radiosity::reading::files::vtu::Grid as Cells;
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::probe::{Probe, ProbeReading, probe};
use radiosity::reading::quality::ReadSettings;
use radiosity::reading::read_error::ReadError;
use radiosity::reading::reader::Reader;
use radiosity::reading::report::Report;
use radiosity::request::cells::require_cells;
use radiosity::request::{KEPT, MethodRequest, ReadRequest, ranges, require_all_light};
use radiosity::solve::solved::Solved;
use radiosity::solve::{Failure, in_threads};
use radiosity::work::Work;
use radiosity::work::ranks::Ranks;
use radiosity::work::wording::{option, words};

use crate::arguments::Arguments;
use crate::arrays::{array, probes, relative};
use crate::error::{Trouble, file_error, warn};
use crate::grid::Grid;
use crate::picture;
use crate::plane::{self, Plane};
use crate::progress::Progress;
use crate::scene::Scene;
use crate::work::work;

/// A scene with its solution.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Solution {
    pub(crate) solved: Arc<Solved>,
    /// Method of the solution; the usual one where the solution was read from a file.
    pub(crate) method: MethodRequest,
    /// Whether the solution was read from a file.
    is_saved: bool,
    report: Report,
    /// The report in JSON, made when it is first asked for.
    told: OnceLock<String>,
}

/// Irradiances, and their standard deviations relative to them.
type Readings<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>);

/// A scene with its solution and its report.
pub(crate) struct ReportedSolution {
    solved: Solved,
    report: Report,
}

impl ReportedSolution {
    /// A solution with its report, computed by as many threads as the solution.
    pub(crate) fn of(solved: Solved) -> Result<Self, Failure> {
        let threads = Ranks::alone().threads(solved.options.threads);
        let report = in_threads(threads, || Report::new(&solved, threads))?;
        Ok(Self { solved, report })
    }
}

/// The solution in a file, with its light groups at these factors.
#[pyfunction]
pub(crate) fn load_solution(
    py: Python<'_>,
    path: &str,
    factors: BTreeMap<String, f64>,
) -> PyResult<Solution> {
    let found = work(py, None, |_| in_threads(0, || read_file(path, &factors))?)?;
    Solution::new(py, found, MethodRequest::default(), true)
}

fn read_file(path: &str, factors: &BTreeMap<String, f64>) -> Result<ReportedSolution, Trouble> {
    let text = radiosity::language::source(path, &[])?;
    if !is_solution(&text.text()) {
        let cure = "solve it first: load(…).solve()";
        return Err(Trouble::new(format!("{}: this is no solution", text.origin), cure));
    }
    let solved = solution_file::read(&text)?;
    let solved = if factors.is_empty() { solved } else { solved.relight(&borrowed(factors))? };
    Ok(ReportedSolution::of(solved)?)
}

fn borrowed(factors: &BTreeMap<String, f64>) -> Vec<(&str, f64)> {
    factors.iter().map(|(name, factor)| (name.as_str(), *factor)).collect()
}

impl Solution {
    /// A solution in Python; gives the warnings of its report.
    pub(crate) fn new(
        py: Python<'_>,
        found: ReportedSolution,
        method: MethodRequest,
        is_saved: bool,
    ) -> PyResult<Self> {
        let ReportedSolution { solved, report } = found;
        report.warnings.iter().try_for_each(|warning| warn(py, &warning.message))?;
        Ok(Self { solved: Arc::new(solved), method, is_saved, report, told: OnceLock::new() })
    }

    /// Reading of the solution as `given`, and number of threads.
    fn reading(&self, given: &mut Arguments<'_>, request: ReadRequest) -> PyResult<(ReadSettings, usize)> {
        let threads = given.value("threads")?.map_or(self.solved.options.threads, ranges::Threads::count);
        request.check(&self.solved.options, &self.method).map_err(Trouble::from)?;
        Ok((request.reading(&self.method, &self.solved, self.is_saved), threads))
    }

    /// Reads the solution by so many threads and reports to `observer` how far it is.
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
            probe(&self.reader(&how), sensors, self.solved.scene.middle, &work)
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
        how.reader(&self.solved.outcome.solution, self.solved.visibility())
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
impl Solution {
    /// Scene of the solution.
    #[getter]
    fn scene(&self) -> Scene {
        Scene { scene: self.solved.scene.clone() }
    }

    /// The report, in JSON.
    #[getter]
    fn report(&self) -> &str {
        self.told.get_or_init(|| {
            let mut report = self.report.clone();
            report.compare_joints(&self.solved);
            serde_json::to_string(&report).expect("a report is plain data")
        })
    }

    /// Coefficients of the radiosity in the orthonormal bases of the elements: an array (bands, unknowns).
    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        let bands = self.solved.outcome.solution.bands();
        let numbers: Vec<f64> =
            bands.iter().flat_map(|band| band.coefficients.radiosity.iter().copied()).collect();
        array(py, &[bands.len(), numbers.len() / bands.len()], numbers)
    }

    /// The surface of each element, and how many coefficients it has.
    #[getter]
    fn elements(&self) -> Vec<(usize, usize)> {
        let elements = self.solved.outcome.solution.elements().list();
        elements.iter().map(|element| (element.surface, element.basis.len())).collect()
    }

    /// Estimated relative error of the quantity that an accuracy was wanted of; none without one.
    #[getter]
    fn error(&self) -> Option<f64> {
        self.report.accuracy_estimate
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
        let numbers = array(py, &[sensors.len(), self.solved.scene.bands.len()], numbers);
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
        let plane = plane.of(&self.solved.scene)?;
        let sensors: Vec<Probe> = Probe::of_plane(&plane).collect();
        let readings = self.sense(py, &sensors, Arguments::of(given)?, "plane", observer.as_ref())?;
        let own = Plane::new(plane, &self.solved.scene, readings);
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
        let scene = &self.solved.scene;
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
        let shot = picture::Shot::of(camera, given, &self.solved, &self.method)?;
        let raster = self.read(py, observer.as_ref(), shot.threads, |progress| {
            shot.take(&self.solved.outcome.solution, self.solved.visibility(), progress)
        })?;
        let [width, height] = raster.size().map(|pixels| pixels as usize);
        let numbers = raster.pixels().flatten().copied().collect();
        Ok(array(py, &[height, width, self.solved.scene.bands.len()], numbers))
    }

    /// The solution with light groups at other factors.
    fn relight(&self, py: Python<'_>, factors: BTreeMap<String, f64>) -> PyResult<Self> {
        let found = work(py, None, |_| -> Result<_, Trouble> {
            Ok(ReportedSolution::of(self.solved.relight(&borrowed(&factors))?)?)
        })?;
        Self::new(py, found, self.method.clone(), self.is_saved)
    }

    /// Writes the solution as `radiosity solve` does: JSON that can be read back, or a grid of VTK.
    fn save(&self, py: Python<'_>, path: &str, is_grid: bool) -> PyResult<()> {
        let cure = |name: &'static str| words("solve the scene without ") + option(name);
        require_all_light(&self.method, KEPT, cure).map_err(Trouble::from)?;
        py.detach(|| match is_grid {
            true => self.write_grid(path),
            false => self.write_json(path),
        })
    }
}

impl Solution {
    fn write_json(&self, path: &str) -> PyResult<()> {
        write(path, |file| Ok(serde_json::to_writer(file, &SolutionFile::new(&self.solved))?))
    }

    fn write_grid(&self, path: &str) -> PyResult<()> {
        let grid = Cells::new(&self.solved.scene, &self.solved.outcome.solution).map_err(Trouble::from)?;
        write(path, |file| grid.write(file))
    }
}

fn write(path: &str, to: impl FnOnce(&mut BufWriter<File>) -> std::io::Result<()>) -> PyResult<()> {
    let written = File::create(path).map(BufWriter::new).and_then(|mut file| {
        to(&mut file)?;
        file.flush()
    });
    written.map_err(|error| file_error(path, &error))
}
