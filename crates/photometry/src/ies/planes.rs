//! Horizontal angles of LM-63: the first and the last tell the symmetry.

use crate::error::{Refusal, refuse};
use crate::symmetry::Symmetry;
use crate::text::told;

/// The symmetry of planes at increasing angles.
///
/// # Errors
/// A range that LM-63 does not have.
pub(super) fn symmetry(planes: &[f64]) -> Result<Symmetry, Refusal> {
    let (first, last) = (planes[0], planes[planes.len() - 1]);
    if first == 90.0 && last == 270.0 {
        return Ok(Symmetry::AboutC90);
    }
    match last {
        _ if first != 0.0 => {}
        0.0 => return Ok(Symmetry::Axial),
        90.0 => return Ok(Symmetry::Quadrant),
        180.0 => return Ok(Symmetry::AboutC0),
        last if last > 180.0 && last <= 360.0 => return Ok(Symmetry::None),
        _ => {}
    }
    refuse(
        format!("the horizontal angles run from {} to {}", told(first), told(last)),
        "let them be 0 alone, or run from 0 to 90, 0 to 180, 90 to 270 or 0 to 360",
    )
}
