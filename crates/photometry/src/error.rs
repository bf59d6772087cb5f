//! Refusals of files: file, place, cause and cure.

use std::fmt;

use crate::file_place::FilePlace;

/// Refusal to read or to write a file. Place and file are added where they are known; a refusal that has its
/// file, such as that of an included one, keeps both.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The file, as it was named; of an included file its own name. Empty while it is not known.
    pub file: String,
    /// Line or byte of the cause, if it is known.
    pub place: Option<FilePlace>,
    /// Cause, without a full stop: "a face has 2 vertices, 3 are the least".
    pub cause: String,
    /// Cure, without a full stop; empty where the cause says so.
    pub cure: String,
    /// Other files, as they were named, words of which the cause or the cure may quote.
    pub quoted: Vec<String>,
}

impl Refusal {
    /// A refusal whose place and file are added later.
    pub fn new(cause: impl Into<String>, cure: impl Into<String>) -> Self {
        let (cause, cure) = (cause.into(), cure.into());
        Self { file: String::new(), place: None, cause, cure, quoted: Vec::new() }
    }

    /// This refusal, which may quote words of other files.
    #[must_use]
    pub fn quoting(mut self, files: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.quoted.extend(files.into_iter().map(Into::into));
        self
    }

    /// This refusal at `place`, unless it has one or is that of a file.
    #[must_use]
    pub fn at(mut self, place: FilePlace) -> Self {
        if self.file.is_empty() {
            self.place = self.place.or(Some(place));
        }
        self
    }

    /// This refusal at `place`, with `what` before its cause, unless it has a place or is that of a file.
    #[must_use]
    pub fn of(mut self, what: &str, place: FilePlace) -> Self {
        if self.file.is_empty() && self.place.is_none() {
            self.cause = format!("{what}: {}", self.cause);
        }
        self.at(place)
    }

    /// This refusal in `file`, unless it has one.
    #[must_use]
    pub fn in_file(mut self, file: &str) -> Self {
        if self.file.is_empty() {
            file.clone_into(&mut self.file);
        }
        self
    }

    /// This refusal in a line of `file`, unless it has a file.
    #[must_use]
    pub fn in_line(self, file: &str, line: usize) -> Self {
        self.at(FilePlace::Line(line)).in_file(file)
    }
}

/// A refusal whose place and file are added later.
///
/// # Errors
/// Always: the refusal.
pub fn refuse<T>(cause: impl Into<String>, cure: impl Into<String>) -> Result<T, Refusal> {
    Err(Refusal::new(cause, cure))
}

/// A refusal at `place`, whose file is added later.
///
/// # Errors
/// Always: the refusal.
pub fn refuse_at<T>(
    place: FilePlace,
    cause: impl Into<String>,
    cure: impl Into<String>,
) -> Result<T, Refusal> {
    Err(Refusal::new(cause, cure).at(place))
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
