//! A warning of a report.

use std::fmt;

use radiosity_work::wording::Wording;
use serde::Serialize;

/// Something the user should know.
#[derive(Clone, Debug, Serialize)]
pub struct Warning {
    /// Stable name of the kind of warning.
    pub code: String,
    /// The warning, with its cure.
    pub message: Wording,
    /// The surface concerned.
    pub surface: Option<String>,
    /// The other surface, where it concerns a pair.
    pub other: Option<String>,
    /// Size of the fault: the error that is left, or a row sum above 1.
    pub size: Option<f64>,
}

impl Warning {
    /// A warning about no surface in particular.
    pub(super) fn general(code: &str, message: impl Into<Wording>) -> Self {
        Self { code: code.to_owned(), message: message.into(), surface: None, other: None, size: None }
    }
}

/// The warning as a line of a summary.
impl fmt::Display for Warning {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        write!(to, "warning: {}", self.message)
    }
}
