//! How far the corners of a sheet may lie off where they are meant to be.
//!
//! The rounding of coordinates is told by the coordinates: those that single precision can hold, or so many decimals, were
//! rounded to them, others to double precision. Short numbers tell nothing: 0.5 is what was typed. Corners off the planes
//! of their own sheets tell more: all of the scene was rounded at least as coarsely. Within its rounding nobody knows which of
//! two sheets is in front. Beside it, a corner is taken to touch a sheet within a millionth of the extent of the smaller.

use radiosity_geom::DVec3;

/// Half a unit in the last place of single and of double precision, relative to the largest coordinate.
const SINGLE: f64 = 1.0 / (1u64 << 24) as f64;
const DOUBLE: f64 = 1.0 / (1u64 << 53) as f64;

/// Bits of the significand that a number of single precision uses at the least if it was rounded to it.
const LONG: u32 = 16;

/// Most decimals that coordinates are looked at for, and the least extent in units of the last of them: shorter numbers
/// may have been typed as they are meant.
const DECIMALS: i32 = 9;
const LEAST_UNITS: f64 = 3e5;

/// By how many roundings a corner may miss a plane through other corners: each misses by up to √3 in space, and a plane
/// through three adds up to three more.
const ROUNDINGS: f64 = 8.0;

/// By how much more than off the planes of their own sheets corners may miss others.
const UNEVEN: f64 = 4.0;

/// Part of its extent within which a sheet touches others.
const TOUCH: f64 = 1e-6;

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
    /// What a coordinate was rounded by.
    pub(super) rounding: f64,
}

impl Tolerance {
    /// Of a sheet with these measures, in a scene whose corners lie off their planes by `unevenness` (scene length).
    pub(super) fn of(measures: &Measures, unevenness: f64) -> Self {
        let rounding = (ROUNDINGS * measures.rounding).max(UNEVEN * unevenness);
        Self { rounding, touch: TOUCH * measures.extent, most: measures.most() }
    }

    /// The `length` (scene length) that was asked for.
    pub(super) fn asked(measures: &Measures, length: f64) -> Self {
        Self { rounding: length, touch: length, most: measures.most() }
    }

    /// The distance within which two sheets touch: the coarser rounding of the two, or the finer size.
    pub(super) fn with(&self, other: &Self) -> f64 {
        self.uncertainty(other).max(self.touch.min(other.touch)).min(self.most).min(other.most)
    }

    /// The distance within which nobody knows which of two sheets is in front.
    pub(super) fn uncertainty(&self, other: &Self) -> f64 {
        self.rounding.max(other.rounding).min(self.most).min(other.most)
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

/// What the coordinates of the corners of a sheet `extent` wide were rounded by (scene length).
pub(super) fn rounding(corners: &[DVec3], extent: f64) -> f64 {
    let coordinates = || corners.iter().flat_map(|x| x.to_array());
    let largest = coordinates().map(f64::abs).fold(0.0, f64::max);
    let single = if coordinates().all(is_single) && coordinates().any(is_long) { SINGLE } else { DOUBLE };
    (single * largest).max(decimal(corners, extent))
}

/// What coordinates were rounded by if all have the same few decimals, and most of them use the last; else 0 (scene length).
fn decimal(corners: &[DVec3], extent: f64) -> f64 {
    let mut coordinates: Vec<f64> = corners.iter().flat_map(|x| x.to_array()).filter(|x| *x != 0.0).collect();
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

fn is_single(x: f64) -> bool {
    f64::from(x as f32) == x
}

/// Whether a number of single precision has a long significand.
fn is_long(x: f64) -> bool {
    let significand = x.to_bits() << 12;
    64 - significand.trailing_zeros().min(64) > LONG
}

/// Rounding of heights and distances of corners with coordinates up to `largest`, in the double precision that all is computed
/// in: what is nearer is one already.
pub(super) fn computed(largest: f64) -> f64 {
    COMPUTED * DOUBLE * largest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rounding_of(corners: [[f64; 3]; 3]) -> f64 {
        rounding(&corners.map(DVec3::from_array), 1.0)
    }

    #[test]
    fn coordinates_tell_their_rounding() {
        // Short numbers were typed; long ones of single precision were rounded to it.
        assert_eq!(rounding_of([[0.0, 0.5, 4.0], [1.0, 2.25, 0.0], [0.0; 3]]), 4.0 * DOUBLE);
        let third = f64::from(1.0f32 / 3.0);
        assert_eq!(rounding_of([[0.0, 0.5, 4.0], [third, 2.25, 0.0], [0.0; 3]]), 4.0 * SINGLE);
        assert_eq!(rounding_of([[0.0, 0.5, 4.0], [1.0 / 3.0, 2.25, 0.0], [0.0; 3]]), 4.0 * DOUBLE);
        // Six decimals of a sheet one wide, but not two of one, and not where one coordinate alone has them.
        assert_eq!(
            rounding_of([[0.123456, 0.5, 4.054321], [0.1, 2.234567, 0.0], [0.345678, 0.0, 0.0]]),
            5e-7
        );
        assert_eq!(rounding_of([[0.123456, 0.5, 4.0], [0.1, 2.25, 0.0], [0.0; 3]]), 4.0 * DOUBLE);
        assert_eq!(rounding_of([[0.12, 0.5, 4.0], [0.1, 2.25, 0.0], [0.0; 3]]), 4.0 * DOUBLE);
    }

    #[test]
    fn long_numbers_have_more_than_sixteen_bits() {
        assert!(!is_long(0.0) && !is_long(1.0) && !is_long(-2.75) && !is_long(f64::from(1 << 20)));
        assert!(is_long(f64::from(0.1f32)) && is_long(-1.0 / 3.0));
    }
}
