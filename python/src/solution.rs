//! Solutions of scenes: their reports; dimmed; written.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::sync::{Arc, OnceLock};

use pyo3::prelude::*;
use radiosity::reading::files::solution_file::{self, SolutionFile, is_solution};
use radiosity::reading::files::vtu::Grid as Cells;
use radiosity::reading::report::Report;
use radiosity::request::{KEPT, MethodRequest, require_all_light};
use radiosity::solve::solved::Solved;
use radiosity::solve::{Failure, in_threads};
use radiosity::work::ranks::Ranks;
use radiosity::work::wording::{option, words};

use crate::error::{Trouble, file_error, warn};
use crate::light::{Found, Light};
use crate::work::work;

/// A scene with its solution.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Solution {
    pub(crate) solved: Arc<Solved>,
    /// Method of the solution; the usual one where the solution was read from a file.
    pub(crate) method: MethodRequest,
    /// Whether the solution was read from a file.
    pub(crate) is_saved: bool,
    report: Report,
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
    fn report(&self) -> &str {
        self.told.get_or_init(|| {
            let mut report = self.report.clone();
            report.compare_joints(&self.solved);
            serde_json::to_string(&report).expect("a report is plain data")
        })
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
