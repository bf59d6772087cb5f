//! The tolerances of lengths, and the one of touching: what is nearer than this is no distance.
//!
//! Scenes come with corners and planes that agree to rounding where they are meant to touch; what is left are the roundings of
//! their coordinates and of what is computed from them. It goes by the extent of the smaller of two things, for a small thing
//! may stand on a large one, or before a sky; and by the distance that a height is measured over, which rounds it.

/// Part of a length that rounding may leave of what is none.
pub const ROUNDING: f64 = 1e-12;

/// Part of a length that is nothing between things that were meant to touch.
pub const COINCIDENT: f64 = 1e-9;

/// Part of a length that is nothing in models of single precision.
pub const LOOSE: f64 = 1e-6;

/// Rounding of a height over a plane, as a part of the distance from the plane's point: some tens of units in the last place.
const OF_DISTANCE: f64 = 1e-14;

/// The length below which things do not differ in place, of which the smaller is `extent` wide and which are measured from a
/// point so far away (all in one unit of length).
pub fn touching(extent: f64, distance: f64) -> f64 {
    COINCIDENT * extent + OF_DISTANCE * distance
}
