//! The shapes, one file each. Each file's head says how its parameters run, which side is the front, its area
//! and its range.

mod affine;
mod bilinear;
mod fold;
mod extrusion;
mod net;
mod parallelogram;
mod polygon;
mod sheared;
mod chart;
mod quarters;
mod tiles;
mod bezier;
mod rational;
mod triangle;
mod trimmed;
mod turn;
mod cone;
mod cylinder;
mod disk;
mod revolution;
mod sphere;
mod sphere_patch;
mod torus;

pub use bezier::Bezier;
pub use bilinear::Bilinear;
pub use cone::Cone;
pub use cylinder::Cylinder;
pub use disk::Disk;
pub use extrusion::Extrusion;
pub use parallelogram::Parallelogram;
pub use polygon::Polygon;
pub use rational::Rational;
pub use revolution::Revolution;
pub use sphere::Sphere;
pub use sphere_patch::SpherePatch;
pub use torus::Torus;
pub use triangle::Triangle;
pub use trimmed::Trimmed;

use crate::ShapeError;
use glam::DVec3;

/// All the way round, in radians.
pub const FULL_TURN: [f64; 2] = [0.0, std::f64::consts::TAU];

/// All coordinates of the field are finite.
fn check_finite(field: &str, x: DVec3) -> Result<(), ShapeError> {
    if x.is_finite() { Ok(()) } else { Err(ShapeError::NotFinite { field: field.into() }) }
}

/// The field is a vector with a direction.
fn check_edge(field: &str, x: DVec3) -> Result<(), ShapeError> {
    check_finite(field, x)?;
    if x.length() > 0.0 { Ok(()) } else { Err(ShapeError::ZeroLength { field: field.into() }) }
}

/// The field is a finite number above zero.
fn check_positive(field: &str, value: f64) -> Result<(), ShapeError> {
    check_finite(field, DVec3::splat(value))?;
    if value > 0.0 { Ok(()) } else { Err(ShapeError::NotPositive { field: field.into(), value }) }
}

/// The field is a finite number not below zero.
fn check_not_negative(field: &str, value: f64) -> Result<(), ShapeError> {
    check_finite(field, DVec3::splat(value))?;
    if value >= 0.0 { Ok(()) } else { Err(ShapeError::Negative { field: field.into(), value }) }
}
