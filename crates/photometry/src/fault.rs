//! Faults: cause and cure, before their place is known.

use crate::error::Refusal;
use crate::file_place::FilePlace;

/// Cause and cure of a fault in a file, without its place, which is added where it is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Cause, without a full stop.
    pub cause: String,
    /// Cure, without a full stop.
    pub cure: String,
}

impl Fault {
    /// A fault with its cure.
    pub fn new(cause: impl Into<String>, cure: impl Into<String>) -> Self {
        Self { cause: cause.into(), cure: cure.into() }
    }

    /// The refusal of `file` for this fault in a line.
    pub fn in_line(self, file: &str, line: usize) -> Refusal {
        Refusal {
            file: file.to_owned(),
            place: Some(FilePlace::Line(line)),
            cause: self.cause,
            cure: self.cure,
        }
    }

    /// The refusal of the whole `file`.
    pub fn of_file(self, file: &str) -> Refusal {
        Refusal { file: file.to_owned(), place: None, cause: self.cause, cure: self.cure }
    }
}
