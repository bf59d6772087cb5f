//! The distance below which two things touch.
//!
//! When a scene has been read, corners and planes that are meant to touch agree to rounding: of their
//! coordinates, and of what is computed from them. The tolerance is relative to the extent of the smaller of
//! two things, since a small thing may stand on a large one, or before a sky; and to the distance over which
//! a height is measured, which rounds it.

use crate::tolerances::{COINCIDENT, OF_DISTANCE};

/// The distance below which two things touch, the smaller of which has the extent `extent`, measured over
/// `distance` (all in one unit of length).
pub fn touching(extent: f64, distance: f64) -> f64 {
    COINCIDENT * extent + OF_DISTANCE * distance
}
