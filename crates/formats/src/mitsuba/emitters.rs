//! Emitters: surfaces that shine.

use std::f64::consts::PI;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::short;

use super::colours::{Colour, Colours};
use super::element::Element;

/// Radiance of red, green and blue where the scene states none: Mitsuba's own.
const USUAL: f64 = 1.0;

/// Exitance of a surface with an emitter: π × radiance. None if it is left out.
///
/// # Errors
/// Values that are no numbers or below 0.
pub(super) fn exitance<'a>(
    emitter: &'a Element,
    colours: &mut Colours<'a, '_>,
) -> Result<Option<[f64; 3]>, Refusal> {
    if emitter.kind() != "area" {
        left_out(emitter, colours);
        return Ok(None);
    }
    match colours.property(emitter, "radiance")?.unwrap_or(Colour::Known([USUAL; 3])) {
        Colour::Known(radiance) => Ok(Some(radiance.map(|value| PI * value))),
        Colour::Unknown(kind) => Err(emitter.refusal(
            format!("the radiance is of type '{kind}', whose mean is not known"),
            "write it as <rgb name=\"radiance\" value=\"…\"/>",
        )),
    }
}

/// Says that an emitter is left out.
pub(super) fn left_out(emitter: &Element, colours: &mut Colours<'_, '_>) {
    emitter.pass_over();
    let text = NoteText::from("emitters of type ").quoting(format!("'{}'", short(emitter.kind())));
    colours.remarks.add(text.then(" are left out"), emitter);
}
