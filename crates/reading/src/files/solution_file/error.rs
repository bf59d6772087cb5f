//! Errors of solution files.

use radiosity_elements::ElementError;
use radiosity_scene::SceneError;
use thiserror::Error;

/// Value of the key `format_version`: the only version that is written and read.
pub(super) const VERSION: u32 = 9;

/// A solution file that cannot be used. Displays as `file: message`; the cure is separate, see
/// [`SolutionError::cure`].
#[derive(Debug, Error)]
#[error("{origin}: {fault}")]
pub struct SolutionError {
    /// File name, or `<stdin>`.
    pub origin: String,
    /// Fault of the file.
    #[source]
    pub fault: SolutionFault,
}

/// A fault of a solution file, without the name of the file.
#[derive(Debug, Error)]
pub enum SolutionFault {
    /// Not the JSON of a solution file.
    #[error("damaged at line {line}, column {column}: {message}")]
    Syntax {
        /// Line, counted from 1.
        line: usize,
        /// Column, counted from 1.
        column: usize,
        /// The parser's message.
        message: String,
    },
    /// Content that its checksum was not made of.
    #[error("damaged: its checksum is not that of its content")]
    Damaged,
    /// A version that this program does not read.
    #[error("the format's version is {found}, this program reads version {VERSION}")]
    Version {
        /// Version that the file states.
        found: u32,
    },
    /// A solution of a scene that was built in code.
    #[error("it does not hold the text of its scene")]
    NoScene,
    /// A solution of masked light by a program that did not write masks.
    #[error("it does not hold its shadow masks")]
    NoMasks,
    /// The scene in it is wrong.
    #[error("the scene in it: {0}")]
    Scene(Box<SceneError>),
    /// The scene in the file cannot be cut into elements as the file says.
    #[error("the scene in it: {0}")]
    Cut(#[from] ElementError),
    /// A part of the file other than an element does not fit the scene in it.
    #[error("{0} is not that of its scene")]
    Whole(Mismatch),
    /// An element does not fit the scene in it.
    #[error("element {index}: {what} is not that of its scene")]
    Element {
        /// Index of the element, counted from 0.
        index: usize,
        /// Part of the element that differs.
        what: Mismatch,
    },
}

/// The part of a file that does not fit the scene in it, e.g. `the rectangle`.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("{0}")]
pub struct Mismatch(pub(super) &'static str);

impl SolutionError {
    /// The way to mend the fault, in a sentence.
    pub fn cure(&self) -> &'static str {
        match self.fault {
            SolutionFault::Version { .. } => {
                "solve the scene again with this program, or read the file with the one that wrote it"
            }
            SolutionFault::NoMasks => {
                "older programs made them again when they read the file: solve the scene again with this program"
            }
            SolutionFault::NoScene => "a scene built in code is solved where it is built",
            _ => "the file is damaged or was changed: solve the scene again",
        }
    }
}
