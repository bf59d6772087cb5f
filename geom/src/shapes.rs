//! The shapes, one file each, and how their parameters run.

mod affine;
mod bilinear;
mod parallelogram;
mod polygon;
mod triangle;
mod trimmed;

pub use bilinear::Bilinear;
pub use parallelogram::Parallelogram;
pub use polygon::Polygon;
pub use triangle::Triangle;
pub use trimmed::Trimmed;

use crate::ShapeError;
use glam::DVec3;

/// All coordinates of the field are finite.
fn check_finite(field: &str, x: DVec3) -> Result<(), ShapeError> {
    if x.is_finite() { Ok(()) } else { Err(ShapeError::NotFinite { field: field.into() }) }
}

/// The field is a vector with a direction.
fn check_edge(field: &str, x: DVec3) -> Result<(), ShapeError> {
    check_finite(field, x)?;
    if x.length() > 0.0 { Ok(()) } else { Err(ShapeError::ZeroLength { field: field.into() }) }
}
