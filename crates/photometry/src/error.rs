//! Refusals of files: file, place, cause and cure.

use std::fmt;

use crate::file_place::FilePlace;

/// Refusal to read or to write a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The file, as it was named; of an included file its own name.
    pub file: String,
    /// Line or byte of the cause, if it is known.
    pub place: Option<FilePlace>,
    /// Cause, without a full stop: "a face has 2 vertices, 3 are the least".
    pub cause: String,
    /// Cure, without a full stop; empty where the cause says so.
    pub cure: String,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Some(FilePlace::Line(line)) => write!(f, "{}:{line}: {}", self.file, self.cause),
            Some(FilePlace::Byte(byte)) => write!(f, "{}: byte {byte}: {}", self.file, self.cause),
            None => write!(f, "{}: {}", self.file, self.cause),
        }
    }
}

impl std::error::Error for Refusal {}
