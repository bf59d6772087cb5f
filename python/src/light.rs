//! Light that is read: at points, on planes, over cells and through cameras.

use numpy::{PyArrayDyn, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::audit::{Checked, Referee};
use radiosity::reading::checked_readings::{CheckEffort, CheckedReadings, PrintedReading};
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::pictures::printed_pixels::{PrintedPixels, settings_of_pictures};
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::probe::{Probe, ProbeFault, ProbeReading, probe};
use radiosity::reading::quality::ReadSettings;
use radiosity::reading::read_error::ReadError;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::request::cells::require_cells;
use radiosity::request::{CheckRequest, MethodRequest, ReadRequest, ranges};
use radiosity::solve::gather::read_irradiance::Deviation;
use radiosity::solve::{Options, in_threads};
use radiosity::work::Work;
use radiosity::work::ranks::Ranks;

use crate::arguments::Arguments;
use crate::arrays::{array, probes};
use crate::checked;
use crate::error::{Trouble, warn};
use crate::found::Found;
use crate::grid::Grid;
use crate::picture::{self, Shot};
use crate::plane::{self, Plane};
use crate::progress::Progress;
use crate::scene::Scene;
use crate::told::Told;
use crate::work::work;

/// The light of a scene.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Light {
    found: Found,
    options: Options,
    /// Method of the light; the usual one where it was read from a file.
    method: MethodRequest,
}

/// Irradiances, the errors that are told of them, and JSON of what a referee found.
type Readings<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>, Option<String>);

/// How light is read, and how much of that is checked.
struct Asked {
    how: ReadSettings,
    check: CheckRequest,
    threads: usize,
}

/// Sensors that are read.
struct Sensors<'a> {
    probes: &'a [Probe],
    /// Name of their plane, if they stand on one.
    plane: Option<&'a str>,
    /// Whether their errors are told.
    tell_errors: bool,
}

impl Light {
    /// Light that was found by this method, with these options.
    pub(crate) fn new(found: Found, options: Options, method: MethodRequest) -> Self {
        Self { found, options, method }
    }

    /// How the light is read as `given`.
    fn asked(&self, given: &mut Arguments<'_>, request: &ReadRequest) -> PyResult<Asked> {
        let check: CheckRequest = given.fields()?;
        let threads = given.value("threads")?.map_or(self.options.threads, ranges::Threads::count);
        request.check(&self.options, &self.method).map_err(Trouble::from)?;
        check.check(&self.options).map_err(Trouble::from)?;
        Ok(Asked { how: self.found.reading(request, &self.method), check, threads })
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

    /// Readings of sensors as `given`; warns where rays leave more of an error than was asked for, and where
    /// a referee finds more than is told.
    fn sense(
        &self,
        py: Python<'_>,
        sensors: &Sensors<'_>,
        given: Arguments<'_>,
        function: &str,
        observer: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Told<ProbeReading>> {
        let mut given = given;
        let request: ReadRequest = given.fields()?;
        let asked = self.asked(&mut given, &request)?;
        given.finish(function)?;
        let told =
            self.read(py, observer, asked.threads, |progress| self.sensed(sensors, &asked, progress))?;
        let told = told.map_err(|(index, fault)| {
            let cure =
                "the polynomials are known on surfaces alone, along their normals: choose read=\"gather\"";
            Trouble::new(format!("points[{index}]: {fault}"), cure)
        })?;
        warn_of_rays(py, told.readings.iter().map(|reading| reading.uncertainty.deviation), asked.how.eps)?;
        checked::warn_of(py, told.checked.as_ref(), asked.how.read)?;
        Ok(told)
    }

    /// Readings of sensors; the number of the first one that cannot be read, and why.
    fn sensed(
        &self,
        sensors: &Sensors<'_>,
        asked: &Asked,
        progress: &Progress,
    ) -> Result<Told<ProbeReading>, (usize, ProbeFault)> {
        let (scene, work) = (self.found.scene(), Work::alone().observed_by(progress));
        let readings = probe(&self.reader(&asked.how), sensors.probes, scene.middle, &work)?;
        let own = self.found.own_error(&self.options, &asked.how);
        let printed = |number: usize| PrintedReading::of_probe(&readings[number], scene, &own, sensors.plane);
        let is_wanted = sensors.tell_errors || asked.check.audit.is_some();
        let effort = is_wanted.then(|| self.effort(asked, readings.len())).flatten();
        let found = self.judged(effort, readings.len(), printed, &work);
        let own = |reading: &ProbeReading| own.of_reading(&reading.irradiance, reading.uncertainty);
        Ok(Told::of(readings, own, found))
    }

    fn reader(&self, how: &ReadSettings) -> Reader<'_> {
        how.reader(self.found.solution(), self.found.visibility())
    }

    fn cells(&self, asked: &Asked, sides: [usize; 2], progress: &Progress) -> Told<Cell> {
        let (scene, work) = (self.found.scene(), Work::alone().observed_by(progress));
        let cells = grid(&self.reader(&asked.how), sides, asked.how.rates, &work);
        let own = self.found.own_error(&self.options, &asked.how);
        let printed = |number: usize| PrintedReading::of_cell(&cells[number], sides, scene, &own);
        let found = self.judged(self.effort(asked, cells.len()), cells.len(), printed, &work);
        Told::of(cells, |cell| own.of_reading(&cell.irradiance, cell.uncertainty), found)
    }

    /// How much of so many readings is checked.
    fn effort(&self, Asked { how, check, .. }: &Asked, count: usize) -> Option<CheckEffort> {
        self.found.effort(check, &self.options, how, count)
    }

    /// Findings of a referee on `count` numbers that `printed` gives; None where it does not look, or can
    /// read none.
    fn judged(
        &self,
        effort: Option<CheckEffort>,
        count: usize,
        printed: impl Fn(usize) -> Option<PrintedReading>,
        work: &Work<'_>,
    ) -> Option<CheckedReadings> {
        let effort = effort?;
        let referee = Referee::of_light(self.found.scene());
        let found = CheckedReadings::of(&referee, count, printed, &effort, work);
        (!found.judged.is_empty()).then_some(found)
    }

    /// A picture, and what a referee found of its pixels where that was asked for.
    fn shot(&self, shot: &Shot, read: ReadMode, progress: &Progress) -> (Raster, Option<Checked>) {
        let (light, visibility) = (self.found.solution(), self.found.visibility());
        let raster = shot.take(read, light, visibility, progress);
        if shot.check.audit.is_none() {
            return (raster, None);
        }
        let asked = Asked { how: settings_of_pictures(read), check: shot.check, threads: shot.threads };
        let (scene, own) = (self.found.scene(), self.found.own_error(&self.options, &asked.how));
        let pixels = PrintedPixels::of(&raster, &shot.camera, scene, visibility, own);
        let (count, work) = (pixels.count(), Work::alone().observed_by(progress));
        let printed = |number: usize| pixels.reading(number);
        let checked = self.judged(self.effort(&asked, count), count, printed, &work);
        let checked = checked.map(|found| found.checked);
        (raster, checked)
    }
}

/// Warns where rays leave more of an error than was asked for.
fn warn_of_rays(
    py: Python<'_>,
    deviations: impl Iterator<Item = Option<Deviation>>,
    asked: f64,
) -> PyResult<()> {
    match ReadError::of(deviations).and_then(|error| error.warning(asked, false)) {
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

    /// Irradiance at points (n, 3) for normals (n, 3): an array (n, bands), its errors (n,), and JSON of what
    /// a referee found, which looks where errors are told or where it is asked for.
    fn irradiance<'py>(
        &self,
        py: Python<'py>,
        positions: PyReadonlyArray2<'_, f64>,
        normals: PyReadonlyArray2<'_, f64>,
        tell_errors: bool,
        given: &Bound<'_, PyDict>,
        observer: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Readings<'py>> {
        let probes = probes(&positions, &normals)?;
        let sensors = Sensors { probes: &probes, plane: None, tell_errors };
        let given = Arguments::of(given)?;
        let Told { readings, errors, checked } =
            self.sense(py, &sensors, given, "irradiance", observer.as_ref())?;
        let numbers = readings.into_iter().flat_map(|reading| reading.irradiance).collect();
        let numbers = array(py, &[probes.len(), self.found.scene().bands.len()], numbers);
        Ok((numbers, array(py, &[probes.len()], errors), checked::json(checked.as_ref())))
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
        let probes: Vec<Probe> = Probe::of_plane(&plane).collect();
        let sensors = Sensors { probes: &probes, plane: Some(plane.name()), tell_errors: true };
        let told = self.sense(py, &sensors, Arguments::of(given)?, "plane", observer.as_ref())?;
        let own = Plane::new(plane, self.found.scene(), told);
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
        let asked = self.asked(&mut given, &request)?;
        given.finish("grid")?;
        let scene = self.found.scene();
        require_cells(sides[0] * sides[1] * scene.surfaces.len(), scene, memory, Ranks::alone())
            .map_err(Trouble::from)?;
        let told =
            self.read(py, observer.as_ref(), asked.threads, |progress| self.cells(&asked, sides, progress))?;
        warn_of_rays(py, told.readings.iter().map(|cell| cell.uncertainty.deviation), asked.how.eps)?;
        checked::warn_of(py, told.checked.as_ref(), asked.how.read)?;
        Ok(Grid::new(told, scene))
    }

    /// A picture: an array (rows, columns, bands).
    fn render<'py>(
        &self,
        py: Python<'py>,
        camera: Option<picture::Given>,
        given: &Bound<'_, PyDict>,
        observer: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let shot = Shot::of(camera, given, self.found.scene(), &self.options, &self.method)?;
        let read = shot.read();
        let (raster, checked) =
            self.read(py, observer.as_ref(), shot.threads, |progress| self.shot(&shot, read, progress))?;
        checked::warn_of(py, checked.as_ref(), read)?;
        let [width, height] = raster.size().map(|pixels| pixels as usize);
        let numbers = raster.pixels().flatten().copied().collect();
        Ok(array(py, &[height, width, self.found.scene().bands.len()], numbers))
    }
}
