//! How far the corners of a sheet may lie off where they are meant to be.
//!
//! The rounding of its coordinates is told by the coordinates: those that single precision can hold were rounded to it,
//! others to double precision. Corners off their own plane tell more: they were rounded at least as coarsely. Beside its
//! rounding, a sheet is taken to touch what is within a millionth of its extent.

use radiosity_geom::DVec3;

/// Half a unit in the last place of single and of double precision, relative to the largest coordinate.
const SINGLE: f64 = 1.0 / (1u64 << 24) as f64;
const DOUBLE: f64 = 1.0 / (1u64 << 53) as f64;

/// By how many roundings a corner may miss a plane through other corners: each misses by up to √3 in space, and a plane
/// through three adds up to three more.
const ROUNDINGS: f64 = 8.0;

/// By how much more than off the plane of its own sheet a corner may miss others.
const UNEVEN: f64 = 4.0;

/// Part of its extent within which a sheet touches others.
const TOUCH: f64 = 1e-6;

/// Largest part of the shortest side, and of the breadth, of a sheet that its corners may move by.
const SHORTEST: f64 = 0.1;
const BREADTH: f64 = 0.01;

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

impl Tolerance {
    /// Of a sheet with these measures; `asked` is the length to be taken instead.
    pub(super) fn of(measures: &Measures, asked: Option<f64>) -> Self {
        let most = (SHORTEST * measures.shortest).min(BREADTH * measures.breadth);
        match asked {
            Some(length) => Self { rounding: length, touch: length, most },
            None => Self {
                rounding: measures.rounding().max(UNEVEN * measures.unevenness),
                touch: TOUCH * measures.extent,
                most,
            },
        }
    }

    /// The distance within which two sheets touch: the coarser rounding of the two, or the finer size.
    pub(super) fn with(&self, other: &Self) -> f64 {
        let wanted = self.rounding.max(other.rounding).max(self.touch.min(other.touch));
        wanted.min(self.most).min(other.most)
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
    /// Largest coordinate, of either sign.
    pub(super) largest: f64,
    /// Whether all coordinates are numbers of single precision.
    pub(super) is_single: bool,
}

impl Measures {
    /// What the corners were rounded by, and planes through them may be off by.
    fn rounding(&self) -> f64 {
        ROUNDINGS * self.largest * if self.is_single { SINGLE } else { DOUBLE }
    }
}

/// Heights of corners that were turned, and over planes through such corners, are rounded some times more.
const COMPUTED: f64 = 32.0;

/// Rounding of heights and distances of corners with coordinates up to `largest`, in the double precision that all is computed
/// in: what is nearer is one already.
pub(super) fn computed(largest: f64) -> f64 {
    COMPUTED * DOUBLE * largest
}

/// Whether single precision holds the point.
pub(super) fn is_single(point: DVec3) -> bool {
    point.to_array().iter().all(|x| f64::from(*x as f32) == *x)
}
