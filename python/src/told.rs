//! Readings, errors, and what a referee found of them, on their way to Python.

use radiosity::audit::Checked;
use radiosity::reading::checked_readings::CheckedReadings;

/// Readings with the errors that are told of them.
pub(crate) struct Told<T> {
    pub(crate) readings: Vec<T>,
    /// Errors in the unit of the readings, root mean squares over the bands.
    pub(crate) errors: Vec<f64>,
    /// Findings of a referee, where it looked.
    pub(crate) checked: Option<Checked>,
}

impl<T> Told<T> {
    /// Readings with own estimates `own` of their errors, and what was found of them.
    pub(crate) fn of(readings: Vec<T>, own: impl Fn(&T) -> f64, found: Option<CheckedReadings>) -> Self {
        let errors = CheckedReadings::all_told(found.as_ref(), readings.iter().map(own));
        Self { readings, errors, checked: found.map(|found| found.checked) }
    }
}
