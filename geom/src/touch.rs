//! The tolerances of lengths, and the one of touching: what is nearer than this is no distance.
//!
//! When a scene has been read, corners and planes that are meant to touch agree to rounding: of their
//! coordinates, and of what is computed from them. The tolerance is relative to the extent of the smaller of
//! two things, since a small thing may stand on a large one, or before a sky; and to the distance over which
//! a height is measured, which rounds it.

/// Part of a length that rounding may leave of what is none.
pub const ROUNDING: f64 = 1e-12;

/// Part of a length that is nothing between things that were meant to touch.
pub const COINCIDENT: f64 = 1e-9;

/// Part of a length that is nothing in models of single precision.
pub const LOOSE: f64 = 1e-6;

/// Rounding of a height over a plane, as a part of the distance from the plane's point: some tens of units in
/// the last place.
const OF_DISTANCE: f64 = 1e-14;

/// The distance below which two things touch, the smaller of which has the extent `extent`, measured over
/// `distance` (all in one unit of length).
pub fn touching(extent: f64, distance: f64) -> f64 {
    COINCIDENT * extent + OF_DISTANCE * distance
}
