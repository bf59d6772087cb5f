//! The tolerance of touching: distances below it count as zero.
//!
//! When a scene has been read, corners and planes that are meant to touch agree to rounding: of their coordinates, and
//! of what is computed from them. The tolerance is relative to the extent of the smaller of two things, since a small
//! thing may stand on a large one, or before a sky; and to the distance over which a height is measured, which rounds
//! it.

/// Part of a thing's extent that counts as zero. Chosen; not tuned.
const OF_EXTENT: f64 = 1e-9;

/// Rounding of a height over a plane, over the distance from the plane's point: 45 · 2⁻⁵². Chosen; not tuned.
const ROUNDING: f64 = 1e-14;

/// The distance below which two things touch, the smaller of which has the extent `extent`, measured over `distance`
/// (all in one unit of length).
pub fn touching(extent: f64, distance: f64) -> f64 {
    OF_EXTENT * extent + ROUNDING * distance
}
