//! Reads a luminaire in either photometric format, by the ending of its file's name.

use std::path::Path;

use crate::Photometry;
use crate::error::Refusal;
use crate::{eulumdat, ies};

/// Reads the luminaire in `bytes`, the contents of `file`: `.ies` is IES LM-63, `.ldt` is EULUMDAT.
///
/// # Errors
/// A file name of another ending; what the format does not allow, with line, cause and cure.
pub fn read(file: &str, bytes: &[u8]) -> Result<Photometry, Refusal> {
    let ending = Path::new(file).extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("ies") => ies::read(file, bytes),
        Some("ldt") => eulumdat::read(file, bytes),
        _ => Err(Refusal::new(
            "the ending tells no photometric format",
            "name it .ies (IES LM-63) or .ldt (EULUMDAT)",
        )
        .in_file(file)),
    }
}
