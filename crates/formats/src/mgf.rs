//! Materials and Geometry Format 2.0 (Greg Ward, "The Materials and Geometry Format", Lawrence Berkeley
//! Laboratory).
//!
//! Kept: all shapes, curved ones as they are; diffuse reflectance `rd` and emittance `ed` with their colours;
//! sides; names of objects; transforms with arrays; includes.

mod chromaticity;
mod contexts;
mod shapes;
mod reader;
pub mod write;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::decode;

use crate::mgf::reader::Reader;
use crate::model::Model;
use radiosity_photometry::files::Files;

/// Reads the scene `file`; `files` finds what it includes.
///
/// # Errors
/// The first line that cannot be followed, of whichever file.
pub fn read(file: &str, bytes: &[u8], files: &dyn Files) -> Result<Model, Refusal> {
    let text = decode(bytes).map_err(|fault| fault.in_file(file))?;
    let mut reader = Reader::new(file, files);
    reader.read(&text)?;
    Ok(reader.finish())
}
