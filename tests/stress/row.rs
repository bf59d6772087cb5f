//! A row of the table of stability: what was tried, how far, how often, the worst error found, what is
//! allowed.

use std::cell::Cell;

/// A row in the making.
pub(crate) struct Row {
    what: &'static str,
    range: String,
    bound: f64,
    unit: &'static str,
    cases: Cell<usize>,
    worst: Cell<f64>,
}

impl Row {
    /// A row of errors that may not exceed `bound`, both in multiples of what `unit` names.
    pub(crate) fn new(what: &'static str, range: impl Into<String>, bound: f64, unit: &'static str) -> Self {
        Self { what, range: range.into(), bound, unit, cases: Cell::new(0), worst: Cell::new(0.0) }
    }

    /// Takes the error of one case in.
    #[track_caller]
    pub(crate) fn add(&self, error: f64, case: impl FnOnce() -> String) {
        assert!(error <= self.bound, "{}: {error:e} exceeds {:e} in {}", self.what, self.bound, case());
        self.cases.set(self.cases.get() + 1);
        self.worst.set(self.worst.get().max(error));
    }
}

impl Drop for Row {
    fn drop(&mut self) {
        let Self { what, range, bound, unit, cases, worst } = self;
        println!("| {what} | {range} | {} | {:.1e} {unit} | {bound:.0e} |", cases.get(), worst.get());
    }
}
