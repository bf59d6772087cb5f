//! Errors of the library as exceptions of Python: what is wrong, the line in question, and the cure.

mod spelling;

use std::ffi::CString;
use std::io;

use pyo3::exceptions::{PyOSError, PyUserWarning, PyValueError};
use pyo3::{PyErr, PyResult, Python, create_exception};
use radiosity::heat::HeatError;
use radiosity::reading::files::solution_file::SolutionError;
use radiosity::reading::files::vtu::VtuError;
use radiosity::request::{LoadError, Refusal, SweepError};
use radiosity::scene::{Fault, FaultKind, SceneError};
use radiosity::solve::Failure;
use radiosity::solve::animation::error::AnimationError;
use radiosity::solve::solved::RelightError;
use radiosity::work::ranks::journal::JournalError;
use radiosity::work::wording::{Wording, words};

pub(crate) use spelling::spelt;

create_exception!(
    radiosity,
    Error,
    PyValueError,
    "What was asked for cannot be done; the text says what is wrong, and how to mend it where that is known."
);

create_exception!(
    radiosity,
    RadiosityWarning,
    PyUserWarning,
    "What was computed is less accurate than was asked for, or something in the scene looks wrong."
);

/// An error on its way to Python.
#[derive(Debug)]
pub(crate) struct Trouble {
    message: String,
    /// The line of a text that is meant, or nothing.
    excerpt: String,
    cure: Option<String>,
    /// Kind of the error of a file that cannot be read; none for other errors.
    of_file: Option<io::ErrorKind>,
}

impl Trouble {
    /// An error with its message and its cure.
    pub(crate) fn new(message: impl Into<String>, cure: impl Into<String>) -> Self {
        Self { message: message.into(), excerpt: String::new(), cure: Some(cure.into()), of_file: None }
    }

    /// An error of the library with its message, and its cure where the message does not give it.
    fn told(message: &Wording, cure: Option<Wording>) -> Self {
        let cure = cure.as_ref().map(spelt);
        Self { message: spelt(message), excerpt: String::new(), cure, of_file: None }
    }

    /// An error of the library whose message names no option.
    fn plain(message: impl ToString, cure: Option<Wording>) -> Self {
        Self::told(&words(message.to_string()), cure)
    }

    /// Message, line and cure.
    fn text(&self) -> String {
        let Self { message, excerpt, cure, .. } = self;
        let mut lines = vec![message.clone()];
        lines.extend(excerpt.lines().map(str::to_owned));
        lines.extend(cure.as_ref().map(|cure| format!("help: {cure}")));
        lines.join("\n")
    }
}

impl From<JournalError> for Trouble {
    fn from(error: JournalError) -> Self {
        let of_file =
            if let JournalError::Transfers { source, .. } = &error { Some(source.kind()) } else { None };
        Self { of_file, ..Self::plain(&error, Some(words(error.cure()))) }
    }
}

impl From<Trouble> for PyErr {
    fn from(trouble: Trouble) -> Self {
        match trouble.of_file {
            // FileNotFoundError, PermissionError, …
            Some(kind) => io::Error::new(kind, trouble.text()).into(),
            None => Error::new_err(trouble.text()),
        }
    }
}

impl From<SceneError> for Trouble {
    fn from(error: SceneError) -> Self {
        let excerpt = error.place.as_ref().map(|place| place.excerpt()).unwrap_or_default();
        let of_file = match error.fault.kind {
            FaultKind::Unreadable(kind) => Some(kind),
            _ => None,
        };
        Self { excerpt, of_file, ..Self::plain(&error, error.advice()) }
    }
}

impl From<Refusal> for Trouble {
    fn from(Refusal { message, cure }: Refusal) -> Self {
        Self::told(&message, Some(cure))
    }
}

impl From<LoadError> for Trouble {
    fn from(error: LoadError) -> Self {
        match error {
            LoadError::Scene(error) => error.into(),
            LoadError::Solved { .. } => Self::new(error.to_string(), "read it with load_solution"),
            LoadError::Refused(refusal) => refusal.into(),
        }
    }
}

impl From<Fault> for Trouble {
    fn from(fault: Fault) -> Self {
        Self::plain(&fault, fault.advice())
    }
}

impl From<SolutionError> for Trouble {
    fn from(error: SolutionError) -> Self {
        Self::plain(&error, Some(error.cure().into()))
    }
}

impl From<RelightError> for Trouble {
    fn from(error: RelightError) -> Self {
        match error {
            RelightError::Scene(error) => error.into(),
            RelightError::NotApart => Self::plain(error, None),
        }
    }
}

impl From<Failure> for Trouble {
    fn from(failure: Failure) -> Self {
        Self::told(&failure.message(), failure.cure())
    }
}

impl From<AnimationError> for Trouble {
    fn from(error: AnimationError) -> Self {
        match error {
            AnimationError::Scene(error) => error.into(),
            AnimationError::Unsolved { failure, .. } | AnimationError::UnsolvedByHand { failure } => {
                (*failure).into()
            }
            other => Self::plain(other, None),
        }
    }
}

impl From<HeatError> for Trouble {
    fn from(error: HeatError) -> Self {
        match error {
            HeatError::Solve(failure) => failure.into(),
            other => Self::plain(&other, other.cure()),
        }
    }
}

impl From<SweepError> for Trouble {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Scene(error) => error.into(),
            SweepError::Heat(error) => error.into(),
        }
    }
}

impl From<VtuError> for Trouble {
    fn from(error: VtuError) -> Self {
        Self::told(&error.message(), Some(error.cure()))
    }
}

/// A file that cannot be read or written.
pub(crate) fn file_error(path: &str, error: &std::io::Error) -> PyErr {
    PyOSError::new_err((error.raw_os_error(), error.to_string(), path.to_owned()))
}

/// Warns the caller of the package.
///
/// # Errors
/// Where warnings are turned into exceptions.
pub(crate) fn warn(py: Python<'_>, message: &Wording) -> PyResult<()> {
    // Texts of C end at NUL, which names may have.
    let text = CString::new(spelt(message).replace('\0', "\\0")).expect("there is no NUL");
    // The first frame is that of the package itself.
    const CALLER: i32 = 2;
    PyErr::warn(py, &py.get_type::<RadiosityWarning>(), &text, CALLER)
}
