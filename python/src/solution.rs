//! Solutions of scenes: their reports; dimmed; written.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::sync::{Arc, OnceLock};

use pyo3::prelude::*;
use radiosity::audit::Checked;
use radiosity::reading::files::solution_file::{self, SolutionFile, is_solution};
use radiosity::reading::files::vtu::Grid as Cells;
use radiosity::reading::report::Report;
use radiosity::request::{CheckRequest, KEPT, MethodRequest, ReadRequest, require_all_light};
use radiosity::solve::solved::Solved;
use radiosity::solve::{Failure, in_threads};
use radiosity::work::Work;
use radiosity::work::ranks::Ranks;
use radiosity::work::wording::{option, words};

use crate::checked;
use crate::error::{Trouble, file_error, warn};
use crate::found::Found;
use crate::light::Light;
use crate::work::work;

/// A scene with its solution.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Solution {
    pub(crate) solved: Arc<Solved>,
    /// Method of the solution; the usual one where the solution was read from a file.
    pub(crate) method: MethodRequest,
    /// Whether the solution was read from a file.
    pub(crate) is_saved: bool,
    check: CheckRequest,
    report: Report,
    /// Findings of a referee, which looks when they are first asked for; None where it does not know such
    /// light.
    checked: OnceLock<Option<Checked>>,
    /// The report in JSON, made when it is first asked for.
    told: OnceLock<String>,
}

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
    Solution::new(py, found, MethodRequest::default(), CheckRequest::default(), true)
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
        check: CheckRequest,
        is_saved: bool,
    ) -> PyResult<Self> {
        let ReportedSolution { solved, report } = found;
        report.warnings.iter().try_for_each(|warning| warn(py, &warning.message))?;
        let (solved, checked, told) = (Arc::new(solved), OnceLock::new(), OnceLock::new());
        Ok(Self { solved, method, is_saved, check, report, checked, told })
    }

    /// Findings of a referee on the light at places of the surfaces and planes, as it is usually read, or
    /// of its polynomials where these were to be accurate; warns where they are more than is told.
    pub(crate) fn judged(
        &self,
        py: Python<'_>,
        observer: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Option<&Checked>> {
        if let Some(checked) = self.checked.get() {
            return Ok(checked.as_ref());
        }
        let Self { solved, is_saved, method, check, .. } = self;
        let settings = ReadRequest::of_written(method, solved, *is_saved);
        let found = work(py, observer, |progress| {
            let work = Work::alone().observed_by(progress);
            let judge = || checked::of_solution(check, solved, *is_saved, &settings, &work);
            in_threads(solved.options.threads, judge)
        })?;
        checked::warn_of(py, found.as_ref(), settings.read)?;
        Ok(self.checked.get_or_init(|| found).as_ref())
    }
}

#[pymethods]
impl Solution {
    /// The light, which is read.
    #[getter]
    fn light(&self) -> Light {
        let found = Found::Solved { solved: Arc::clone(&self.solved), is_saved: self.is_saved };
        Light::new(found, self.solved.options, self.method.clone())
    }

    /// The report, in JSON.
    #[getter]
    fn report(&self, py: Python<'_>) -> PyResult<&str> {
        let checked = self.judged(py, None)?;
        let told = self.told.get_or_init(|| {
            let mut report = self.report.clone();
            report.compare_joints(&self.solved);
            let read = ReadRequest::of_written(&self.method, &self.solved, self.is_saved).read;
            checked.cloned().into_iter().for_each(|checked| report.add_checked(checked, read));
            serde_json::to_string(&report).expect("a report is plain data")
        });
        Ok(told)
    }

    /// JSON of what a referee found; None where it does not know such light.
    #[getter]
    fn checked(&self, py: Python<'_>) -> PyResult<Option<String>> {
        Ok(checked::json(self.judged(py, None)?))
    }

    /// Estimated relative error of the quantity that an accuracy was wanted of; none without one.
    #[getter]
    fn error(&self) -> Option<f64> {
        self.report.accuracy_estimate
    }

    /// The solution with light groups at other factors.
    fn relight(&self, py: Python<'_>, factors: BTreeMap<String, f64>) -> PyResult<Self> {
        let found = work(py, None, |_| -> Result<_, Trouble> {
            Ok(ReportedSolution::of(self.solved.relight(&borrowed(&factors))?)?)
        })?;
        Self::new(py, found, self.method.clone(), self.check, self.is_saved)
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
