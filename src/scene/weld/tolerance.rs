//! How far the corners of a sheet may lie off where they are meant to be.
//!
//! The rounding of coordinates is told by the coordinates: to single or double precision
//! ([`coordinate_rounding`](radiosity_geom::coordinate_rounding)), or to so many decimals where all of the scene has no more and
//! most use the last. Corners off the planes of their own sheets tell as well: all of the scene may be rounded as coarsely. Within
//! this uncertainty nobody knows which of two sheets is in front. Beside it, a corner is taken to touch a sheet within a
//! millionth of the extent of the smaller.

use radiosity_geom::{DVec3, LOOSE};

/// Unit roundoff of double precision.
const DOUBLE: f64 = 1.0 / (1u64 << 53) as f64;

/// Most decimals that coordinates are looked at for, and the least extent of a scene in units of the last of them: shorter
/// numbers may have been typed as they are meant.
const DECIMALS: i32 = 9;
const LEAST_UNITS: f64 = 3e5;

/// By how many roundings a corner may miss a plane through other corners: each misses by up to one, and a plane through
/// three adds up to three more where it is extended; twice that.
const ROUNDINGS: f64 = 8.0;

/// By how much more than off the planes of their own sheets corners may miss others; and the largest part of its own extent that
/// a sheet believes other sheets of, as much as a flat shape may be off its plane.
const UNEVEN: f64 = 4.0;
const MOST_UNEVEN: f64 = 2e-5;

/// Largest part of the shortest side, and of the breadth, of a sheet that its corners may move by.
const SHORTEST: f64 = 0.1;
const BREADTH: f64 = 0.01;

/// Heights of corners that were turned, and over planes through such corners, are rounded some times more.
const COMPUTED: f64 = 32.0;

/// The tolerances of one sheet (scene length).
#[derive(Clone, Copy, Debug)]
pub(super) struct Tolerance {
    /// Of its coordinates.
    rounding: f64,
    /// Of those of the scene, as its corners off planes tell.
    noise: f64,
    /// By its size.
    touch: f64,
    /// What must not be exceeded, or the sheet may collapse.
    most: f64,
}

/// What the tolerance of a sheet is judged by (scene lengths).
#[derive(Clone, Copy, Debug)]
pub(super) struct Measures {
    /// Diagonal of the box around it.
    pub(super) extent: f64,
    /// Shortest side.
    pub(super) shortest: f64,
    /// Area over extent.
    pub(super) breadth: f64,
    /// Largest height of a corner over the plane of the outline.
    pub(super) unevenness: f64,
    /// What its coordinates were rounded by, across its plane.
    pub(super) rounding: f64,
}

/// What all sheets of a scene tell together (scene lengths).
#[derive(Clone, Copy, Debug)]
pub(super) struct Evidence {
    /// The largest height of a corner over the plane of its own sheet.
    pub(super) unevenness: f64,
    /// What coordinates were rounded by that have few decimals.
    pub(super) decimal: f64,
}

impl Tolerance {
    /// Of a sheet with these measures in a scene with that evidence.
    pub(super) fn of(measures: &Measures, evidence: Evidence) -> Self {
        Self {
            rounding: ROUNDINGS * measures.rounding.max(evidence.decimal),
            noise: UNEVEN * evidence.unevenness.min(MOST_UNEVEN * measures.extent).max(measures.unevenness),
            touch: LOOSE * measures.extent,
            most: measures.most(),
        }
    }

    /// The `length` (scene length) that was asked for.
    pub(super) fn asked(measures: &Measures, length: f64) -> Self {
        Self { rounding: length, noise: length, touch: length, most: measures.most() }
    }

    /// The distance within which two sheets touch.
    pub(super) fn with(&self, other: &Self) -> f64 {
        self.uncertainty(other).max(self.touch.min(other.touch)).min(self.most).min(other.most)
    }

    /// The distance within which nobody knows which of two sheets is in front: the coarser rounding of the two, or the finer noise.
    pub(super) fn uncertainty(&self, other: &Self) -> f64 {
        let rounding = self.rounding.max(other.rounding);
        rounding.max(self.noise.min(other.noise)).min(self.most).min(other.most)
    }

    /// Its own, with a sheet that is rounded and as large as itself.
    pub(super) fn largest(&self) -> f64 {
        self.with(self)
    }

    /// No pair with this sheet has a larger one.
    pub(super) fn most(&self) -> f64 {
        self.most
    }
}

impl Measures {
    fn most(&self) -> f64 {
        (SHORTEST * self.shortest).min(BREADTH * self.breadth)
    }
}

/// What coordinates were rounded by in a scene `extent` wide if all have the same few decimals, and most of them use the last;
/// else 0 (scene length).
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

/// Rounding of heights and distances of corners with coordinates up to `largest`, in the double precision that all is computed
/// in: what is nearer is one already.
pub(super) fn computed(largest: f64) -> f64 {
    COMPUTED * DOUBLE * largest
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
