//! Faults: cause and cure, before their place is known.

use crate::error::Refusal;
use crate::place::Place;

/// What is wrong in a file and how to mend it. Its place is added by whoever knows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// What is wrong, without a full stop.
    pub cause: String,
    /// How to mend it, without a full stop.
    pub cure: String,
}

impl Fault {
    /// A fault with its cure.
    pub fn new(cause: impl Into<String>, cure: impl Into<String>) -> Self {
        Self { cause: cause.into(), cure: cure.into() }
    }

    /// The refusal of `file` for this fault in a line.
    pub fn in_line(self, file: &str, line: usize) -> Refusal {
        Refusal { file: file.to_owned(), place: Some(Place::Line(line)), cause: self.cause, cure: self.cure }
    }

    /// The refusal of the whole `file`.
    pub fn of_file(self, file: &str) -> Refusal {
        Refusal { file: file.to_owned(), place: None, cause: self.cause, cure: self.cure }
    }
}
