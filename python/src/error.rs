//! Errors of the library as exceptions of Python: what is wrong, the line in question, and the cure.

use pyo3::exceptions::PyValueError;
use pyo3::{PyErr, create_exception};
use radiosity::output::solution_file::SolutionError;
use radiosity::scene::{Fault, SceneError};
use radiosity::solve::Failure;
use radiosity::solved::RelightError;

create_exception!(
    radiosity,
    Error,
    PyValueError,
    "What was asked for cannot be done; the text says what is wrong, and how to mend it where that is known."
);

/// An error on its way to Python.
#[derive(Debug)]
pub(crate) struct Trouble {
    message: String,
    cure: Option<String>,
}

impl Trouble {
    /// What is wrong, and how to mend it.
    pub(crate) fn new(message: impl Into<String>, cure: impl Into<String>) -> Self {
        Self { message: message.into(), cure: Some(cure.into()) }
    }

    /// The text: message and cure.
    fn text(self) -> String {
        match self.cure {
            Some(cure) => format!("{}\nhelp: {cure}", self.message),
            None => self.message,
        }
    }
}

impl From<Trouble> for PyErr {
    fn from(trouble: Trouble) -> Self {
        Error::new_err(trouble.text())
    }
}

impl From<SceneError> for Trouble {
    fn from(error: SceneError) -> Self {
        Self { message: error.to_string(), cure: error.cure() }
    }
}

impl From<Fault> for Trouble {
    fn from(fault: Fault) -> Self {
        Self { message: fault.to_string(), cure: fault.cure() }
    }
}

impl From<SolutionError> for Trouble {
    fn from(error: SolutionError) -> Self {
        Self { message: error.to_string(), cure: Some(error.cure().to_owned()) }
    }
}

impl From<RelightError> for Trouble {
    fn from(error: RelightError) -> Self {
        match error {
            RelightError::Scene(error) => error.into(),
            RelightError::NotApart => Self { message: error.to_string(), cure: None },
        }
    }
}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Self {
        Self { message: failure.to_string(), cure: None }
    }
}
