//! Findings of a referee on printed numbers, as Python has them.

use pyo3::prelude::*;
use radiosity::audit::{Checked, Referee};
use radiosity::reading::judging::JudgedRun;
use radiosity::reading::quality::ReadSettings;
use radiosity::reading::reader::ReadMode;
use radiosity::reading::report::underestimated;
use radiosity::request::CheckRequest;
use radiosity::solve::solved::Solved;
use radiosity::work::Work;
use serde::Serialize;

use crate::error::warn;

/// A check with its line.
#[derive(Serialize)]
struct CheckedLine<'a> {
    #[serde(flatten)]
    checked: &'a Checked,
    line: String,
}

/// JSON of a check, with the line of the command's summary; None where nothing was checked.
pub(crate) fn json(checked: Option<&Checked>) -> Option<String> {
    checked.map(|checked| {
        let told = CheckedLine { checked, line: checked.to_string() };
        serde_json::to_string(&told).expect("it is plain data")
    })
}

/// Warns where light that was read from `read` is off by more than its method tells.
pub(crate) fn warn_of(py: Python<'_>, checked: Option<&Checked>, read: ReadMode) -> PyResult<()> {
    match checked.and_then(|checked| underestimated(checked, read)) {
        Some(warning) => warn(py, &warning.message),
        None => Ok(()),
    }
}

/// The check of a solution at places of its surfaces and planes that are read with `settings`.
pub(crate) fn of_solution(
    check: &CheckRequest,
    solved: &Solved,
    is_saved: bool,
    settings: &ReadSettings,
    work: &Work<'_>,
) -> Option<Checked> {
    let effort = check.of_solution(solved, is_saved, 0.0, usize::MAX)?;
    let referee = Referee::of_light(&solved.scene);
    let run = JudgedRun::of_all_light(solved, settings, None, &referee, &effort, work);
    (!run.readings.is_empty()).then_some(run.checked)
}
