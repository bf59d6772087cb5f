//! Reads a scene in any of the formats.

use std::borrow::Cow;

use radiosity_work::printable::printable;

use crate::format::Format;
use crate::model::Model;
use crate::{gltf, mgf, mitsuba, obj, ply, rad, stl, vs3};
use radiosity_photometry::error::Refusal;
use radiosity_photometry::files::Files;

/// Reads `bytes`, the contents of `file`, in a format; `files` finds the files that it names.
///
/// # Errors
/// A text that the format does not allow, with line or byte, cause and cure.
pub fn read(format: Format, file: &str, bytes: &[u8], files: &dyn Files) -> Result<Model, Refusal> {
    let reader = match format {
        Format::Mgf => mgf::read,
        Format::Obj => obj::read,
        Format::Gltf => gltf::read,
        Format::Stl => stl::read,
        Format::Ply => ply::read,
        Format::Mitsuba => mitsuba::read,
        Format::Rad => rad::read,
        Format::Vs3 => vs3::read,
    };
    reader(file, bytes, files).map(printable_names)
}

/// The model with its title and its names as a terminal prints them.
fn printable_names(mut model: Model) -> Model {
    let materials = model.materials.iter_mut().map(|own| &mut own.name);
    let surfaces = model.surfaces.iter_mut().map(|own| &mut own.name);
    for name in materials.chain(surfaces).chain(&mut model.title) {
        if let Cow::Owned(shown) = printable(name) {
            *name = shown;
        }
    }
    model
}
