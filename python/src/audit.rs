//! Solutions judged by a referee.

use numpy::PyArrayDyn;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use radiosity::audit::Referee;
use radiosity::reading::checked_readings::CheckEffort;
use radiosity::reading::judging::{JudgedReading, JudgedRun};
use radiosity::request::{AuditRequest, ReadRequest, ranges, require_all_light};
use radiosity::solve::in_threads;
use radiosity::work::Work;
use radiosity::work::wording::{option, words};

use crate::arguments::Arguments;
use crate::arrays::array;
use crate::error::Trouble;
use crate::solution::Solution;
use crate::work::work;

/// Readings of a solution, judged.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Audit {
    run: JudgedRun,
    judging: CheckEffort,
    bands: usize,
}

/// Judges the light of a solution.
#[pyfunction]
pub(crate) fn audit_of(
    py: Python<'_>,
    solution: &Solution,
    given: &Bound<'_, PyDict>,
    observer: Option<Bound<'_, PyAny>>,
) -> PyResult<Audit> {
    let Solution { solved, method, is_saved, .. } = solution;
    let mut given = Arguments::of(given)?;
    let request: AuditRequest = given.fields()?;
    let read: ReadRequest = given.fields()?;
    let threads = given.value("threads")?.map_or(solved.options.threads, ranges::Threads::count);
    given.finish("audit")?;
    let cure = |name: &'static str| words("solve the scene without ") + option(name);
    require_all_light(method, "the referee judges all light", cure).map_err(Trouble::from)?;
    read.check(&solved.options, method).map_err(Trouble::from)?;
    let reading = read.reading(method, solved, *is_saved);
    let judging = request.judging(&solved.scene);
    let run = work(py, observer.as_ref(), |progress| {
        let judge = || {
            let referee = Referee::of_light(&solved.scene);
            JudgedRun::of(solved, &reading, &referee, &judging, &Work::alone().observed_by(progress))
        };
        in_threads(threads, judge)
    })?;
    if run.readings.len() < 2 {
        let message = format!("{} places can be read, too few to be judged", run.readings.len());
        return Err(Trouble::new(message, "ask for more readings=, or take read=\"gather\"").into());
    }
    Ok(Audit { run, judging, bands: solved.scene.bands.len() })
}

impl Audit {
    /// Numbers of each reading, so many: an array (n, `count`).
    fn rows<'py>(
        &self,
        py: Python<'py>,
        count: usize,
        of: impl Fn(&JudgedReading) -> Vec<f64>,
    ) -> Bound<'py, PyArrayDyn<f64>> {
        let readings = &self.run.readings;
        array(py, &[readings.len(), count], readings.iter().flat_map(of).collect())
    }
}

#[pymethods]
impl Audit {
    #[getter]
    fn positions<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.rows(py, 3, |own| own.probe.position.to_array().to_vec())
    }

    #[getter]
    fn normals<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.rows(py, 3, |own| own.probe.normal.to_array().to_vec())
    }

    /// The surface or the plane of each reading.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.run.readings.iter().map(|own| own.judged.class.clone()).collect()
    }

    #[getter]
    fn printed<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.rows(py, self.bands, |own| own.judged.printed.clone())
    }

    #[getter]
    fn found<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.rows(py, self.bands, |own| own.judged.estimate.bands.iter().map(|mean| mean.value).collect())
    }

    #[getter]
    fn found_error<'py>(&self, py: Python<'py>) -> Bound<'py, PyArrayDyn<f64>> {
        self.rows(py, self.bands, |own| own.judged.estimate.bands.iter().map(|mean| mean.error).collect())
    }

    /// Error, its standard error, the least that would have been seen, what the run tells.
    #[getter]
    fn errors(&self) -> (f64, f64, f64, f64) {
        let verdict = &self.run.verdict;
        (verdict.error(), verdict.error_sd(), verdict.visible(), self.run.checked.own_error)
    }

    #[getter]
    fn finds_more(&self) -> bool {
        self.run.checked.finds_more()
    }

    /// Rays, walks for each reading, places that could not be read.
    #[getter]
    fn counts(&self) -> (u64, u64, usize) {
        (self.run.verdict.rays, self.judging.effort.walks(), self.run.unread)
    }

    /// The verdict, in JSON.
    #[getter]
    fn verdict(&self) -> String {
        serde_json::to_string(&self.run.verdict).expect("a verdict is plain data")
    }

    /// The verdict in a line.
    #[getter]
    fn line(&self) -> String {
        self.run.checked.to_string()
    }
}
