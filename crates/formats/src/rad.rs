//! Radiance scene descriptions (Greg Ward, Radiance reference manual, "Scene Description").
//!
//! Kept: polygons, spheres, cylinders, cones, rings and their inside-out kin; the diffuse part of materials;
//! lamps, whose exitance is π times their radiance. Surfaces reflect on both sides; lamps emit from their
//! front. Commands are not run, but `xform` and `genbox` are followed.

mod scanner;
mod materials;
mod shapes;
mod commands;
mod reader;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::decode;

use crate::model::Model;
use crate::rad::commands::Frame;
use crate::rad::reader::Reader;
use radiosity_photometry::files::Files;

/// Reads the scene `file`; `files` finds what its commands name.
///
/// # Errors
/// The first item that cannot be followed, of whichever file.
pub fn read(file: &str, bytes: &[u8], files: &dyn Files) -> Result<Model, Refusal> {
    let text = decode(bytes).map_err(|fault| fault.in_file(file))?;
    let mut reader = Reader::new(file, files);
    reader.read(&text, &Frame::default())?;
    Ok(reader.finish())
}
