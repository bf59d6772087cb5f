//! The unit of exitance, irradiance and radiosity: a text that is printed and never computed with.

use crate::{
    fault::{Fault, FaultKind},
    names::check_text,
};

/// The unit of scenes that state none.
pub const USUAL: &str = "W/m²";

/// Most characters of a unit, so that it stands in a legend. Chosen.
const LONGEST: usize = 16;

/// Refuses a unit that cannot stand in a legend: a blank one, one of several lines or of more than 16
/// characters.
pub fn check_unit(text: &str) -> Result<(), Fault> {
    check_text(text)?;
    if text.chars().any(char::is_control) {
        return Err(bad_unit("the unit is more than one line"));
    }
    match text.chars().count() {
        0..=LONGEST => Ok(()),
        _ => Err(bad_unit("the unit is longer than 16 characters")),
    }
}

fn bad_unit(cause: &str) -> Fault {
    Fault::new(FaultKind::BadText, cause, "write a short text, e.g. \"lx\" or \"W/m²\"")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_short_and_stand_on_a_line() {
        for unit in [USUAL, "lx", "µW cm⁻² nm⁻¹", "1234567890123456"] {
            assert!(check_unit(unit).is_ok(), "{unit}");
        }
        for unit in ["", " ", "l\nx", "12345678901234567"] {
            assert!(check_unit(unit).is_err(), "{unit}");
        }
    }
}
