//! Writes a model in any of the formats that are written.

use crate::format::{Format, Written};
use crate::model::Model;
use crate::{mgf, obj, vs3};
use radiosity_photometry::error::{Refusal, refuse};

/// The formats that are written.
pub const WRITTEN: [Format; 3] = [Format::Mgf, Format::Vs3, Format::Obj];

/// The texts of a model in a format; `materials` is the name of the file of materials, where the format has
/// one.
///
/// # Errors
/// A format that is only read, and what the format has no words for.
pub fn write(format: Format, model: &Model, materials: &str) -> Result<Written, Refusal> {
    let alone = |text: String| Written { text, materials: None };
    match format {
        Format::Mgf => mgf::write::write(model).map(alone),
        Format::Vs3 => vs3::write::write(model).map(alone),
        Format::Obj => obj::write::write(model, materials),
        Format::Gltf | Format::Stl | Format::Ply | Format::Mitsuba | Format::Rad => refuse(
            "this format is only read",
            format!("write one of {}", WRITTEN.map(Format::name).join(", ")),
        ),
    }
}
