//! Faults with their places, before the file is known.

use crate::error::Refusal;
use crate::fault::Fault;
use crate::file_place::FilePlace;
use crate::text::decode;

/// A fault with its place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Located {
    /// Cause and cure of the fault.
    pub(crate) fault: Fault,
    /// Line or byte of the fault.
    place: FilePlace,
}

impl Located {
    /// A fault at `place`.
    pub fn new(place: FilePlace, cause: impl Into<String>, cure: impl Into<String>) -> Self {
        Self { fault: Fault::new(cause, cure), place }
    }

    /// The refusal of `file` for this fault.
    pub fn in_file(self, file: &str) -> Refusal {
        let Fault { cause, cure } = self.fault;
        Refusal { file: file.to_owned(), place: Some(self.place), cause, cure }
    }
}

impl Fault {
    /// This fault at `place`.
    pub fn at(self, place: FilePlace) -> Located {
        Located { fault: self, place }
    }
}

/// The characters of a text, as [`decode`] reads them.
///
/// # Errors
/// A zero byte, at its place.
pub fn decoded(bytes: &[u8]) -> Result<String, Located> {
    let zero = || bytes.iter().position(|byte| *byte == 0).unwrap_or(0);
    decode(bytes).map_err(|fault| fault.at(FilePlace::Byte(zero())))
}
