//! Tolerances: distances that the corners of a sheet may lie off their intended positions.
//!
//! The coordinates themselves show their rounding: to single or double precision
//! ([`coordinate_rounding`](radiosity_geom::coordinate_rounding)), or to a number of decimals if no
//! coordinate of the scene has more and most use the last one. Corners off the planes of their own sheets
//! show it too: all of the scene may be rounded as coarsely. Within this uncertainty it is unknown which of
//! two sheets is in front. In addition a corner touches a sheet within a millionth of the smaller extent.

use radiosity_geom::{DVec3, LOOSE, PLANARITY, ROUNDINGS_OF_PLANE, ROUNDOFF_OF_DOUBLE};

/// Most decimals that are considered: at an extent of 1 the tenth is below the tolerance of touching.
const DECIMALS: i32 = 9;

/// Least extent of a scene in units of the last decimal: shorter numbers may have been typed as meant. A room
/// of 3 with five decimals was rounded, one in whole centimetres was not. An arbitrary choice: with a larger
/// value fewer rounded scenes are mended; with a smaller one gaps of one unit that were typed are closed.
const LEAST_UNITS: f64 = 3e5;

/// Distance from other sheets that corners may have, over that from the planes of their own sheets: as far as
/// a corner is off its plane another one may be, and the three that its plane goes through.
const UNEVEN: f64 = 4.0;

/// Largest move of corners over the shortest side of their sheet: two corners must not meet. An arbitrary
/// choice: with a larger value sheets change their shape visibly; with a smaller one slender ones are not
/// welded.
const SHORTEST: f64 = 0.1;

/// Largest move of corners over the breadth of their sheet, less than over a side since its plane must not
/// turn: by two corners that move against each other it turns by a fiftieth.
const BREADTH: f64 = 0.01;

/// Rounding of heights of turned corners, and over planes through such corners, in units of 2⁻⁵³: some eight
/// roundings of the corner, and of each of the three that the plane goes through.
const COMPUTED: f64 = 32.0;

/// The tolerances of one sheet (scene length).
#[derive(Clone, Copy, Debug)]
pub(super) struct Tolerance {
    /// Rounding of its coordinates.
    rounding: f64,
    /// Rounding of the scene's coordinates, judged by corners off their planes.
    noise: f64,
    /// Tolerance in proportion to its size.
    touch: f64,
    /// Upper bound of all its tolerances, beyond which the sheet may collapse.
    most: f64,
}

/// Measures of a sheet that decide its tolerance (scene lengths).
#[derive(Clone, Copy, Debug)]
pub(super) struct Measures {
    /// Diagonal of the box around it.
    pub(super) extent: f64,
    /// Length of the shortest side.
    pub(super) shortest: f64,
    /// Area over extent.
    pub(super) breadth: f64,
    /// Largest height of a corner over the plane of the outline.
    pub(super) unevenness: f64,
    /// Rounding of its coordinates, perpendicular to its plane.
    pub(super) rounding: f64,
}

/// Evidence of rounding from all sheets of a scene (scene lengths).
#[derive(Clone, Copy, Debug)]
pub(super) struct Evidence {
    /// The largest height of a corner over the plane of its own sheet.
    pub(super) unevenness: f64,
    /// Rounding of coordinates with few decimals.
    pub(super) decimal: f64,
}

impl Tolerance {
    /// The tolerance of a sheet with these measures in a scene with that evidence.
    pub(super) fn of(measures: &Measures, evidence: Evidence) -> Self {
        Self {
            rounding: ROUNDINGS_OF_PLANE * measures.rounding.max(evidence.decimal),
            noise: UNEVEN * evidence.unevenness.min(PLANARITY * measures.extent).max(measures.unevenness),
            touch: LOOSE * measures.extent,
            most: measures.most(),
        }
    }

    /// The tolerance `length` (scene length) that the user gave.
    pub(super) fn asked(measures: &Measures, length: f64) -> Self {
        Self { rounding: length, noise: length, touch: length, most: measures.most() }
    }

    /// The distance within which two sheets touch.
    pub(super) fn with(&self, other: &Self) -> f64 {
        self.uncertainty(other).max(self.touch.min(other.touch)).min(self.most).min(other.most)
    }

    /// The distance within which either sheet may be in front: the coarser rounding of the two, or the finer
    /// noise.
    pub(super) fn uncertainty(&self, other: &Self) -> f64 {
        let rounding = self.rounding.max(other.rounding);
        rounding.max(self.noise.min(other.noise)).min(self.most).min(other.most)
    }

    /// Tolerance of the sheet with an equal one (scene length).
    pub(super) fn largest(&self) -> f64 {
        self.with(self)
    }

    /// Upper bound of its tolerance with any other sheet (scene length).
    pub(super) fn most(&self) -> f64 {
        self.most
    }
}

impl Measures {
    fn most(&self) -> f64 {
        (SHORTEST * self.shortest).min(BREADTH * self.breadth)
    }
}

/// Rounding of the coordinates (scene length) in a scene of the extent `extent` if all have the same few
/// decimals, and most use the last one; else 0.
pub(super) fn decimal(corners: impl Iterator<Item = DVec3>, extent: f64) -> f64 {
    let mut coordinates: Vec<f64> = corners.flat_map(|x| x.to_array()).filter(|x| *x != 0.0).collect();
    coordinates.sort_unstable_by(f64::total_cmp);
    coordinates.dedup();
    let fits = |unit: f64, x: f64| (x * unit).round() / unit == x;
    let units = (0..=DECIMALS).map(|count| 10f64.powi(count));
    let Some(unit) = units.into_iter().find(|unit| coordinates.iter().all(|x| fits(*unit, *x))) else {
        return 0.0;
    };
    let used = coordinates.iter().filter(|x| !fits(0.1 * unit, **x)).count();
    if extent * unit >= LEAST_UNITS && 2 * used > coordinates.len() { 0.5 / unit } else { 0.0 }
}

/// Rounding in double precision of heights and distances of corners with coordinates up to `largest` (scene
/// length).
pub(super) fn computed(largest: f64) -> f64 {
    COMPUTED * ROUNDOFF_OF_DOUBLE * largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_told_where_most_coordinates_use_the_last() {
        let of = |corners: [[f64; 3]; 3]| decimal(corners.into_iter().map(DVec3::from_array), 1.0);
        assert_eq!(of([[0.123456, 0.5, 4.054321], [0.1, 2.234567, 0.0], [0.345678, 0.0, 0.0]]), 5e-7);
        // One coordinate alone, and too few decimals for a scene one wide.
        assert_eq!(of([[0.123456, 0.5, 4.0], [0.1, 2.25, 0.0], [0.0; 3]]), 0.0);
        assert_eq!(of([[0.1234, 0.5, 4.0543], [0.1, 2.2345, 0.0], [0.3456, 0.0, 0.0]]), 0.0);
        assert_eq!(of([[1.0 / 3.0, 0.5, 4.0], [0.1, 2.25, 0.0], [0.0; 3]]), 0.0);
    }

    #[test]
    fn small_sheets_do_not_believe_that_they_are_as_uneven_as_large_ones() {
        let measures = |extent: f64| Measures {
            extent,
            shortest: extent,
            breadth: extent,
            unevenness: 0.0,
            rounding: 0.0,
        };
        let evidence = Evidence { unevenness: 0.1, decimal: 0.0 };
        let [small, large] = [1.0, 1e4].map(|extent| Tolerance::of(&measures(extent), evidence));
        assert!(small.with(&small) < 1e-4 && small.with(&large) < 1e-4 && large.with(&large) > 0.1);
    }
}
