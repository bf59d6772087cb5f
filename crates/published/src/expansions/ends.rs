//! The two elements of a pair that moves, with what is rounding and what is accurate enough.

use radiosity_elements::Element;
use radiosity_geom::Motion;

use super::course::Course;

/// Steps of this part of the extents of a pair are rounding.
const ROUNDED: f64 = 1e-12;

/// Distances from a course, over the extents of a pair and the tolerance of its block, that are left out of
/// account, if they are not below rounding. Chosen: the axis of the first step of a rotation is known to some
/// hundred roundings.
const NEGLIGIBLE: f64 = 1e-6;

/// A pair of elements that moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ends<'a> {
    pub elements: [&'a Element; 2],
    /// Sum of their extents (scene length).
    pub extent: f64,
    /// Error that its block may have, relative to the largest entry.
    pub tolerance: f64,
    /// Samples of its last integral, if they are known.
    pub integral: Option<u64>,
}

impl Ends<'_> {
    /// Whether the second element moves by less than rounding from one place to another.
    pub(super) fn rests(&self, from: &Motion, to: &Motion) -> bool {
        let rounded = ROUNDED * self.extent;
        self.elements[1].hull.iter().all(|y| from.point(*y).distance(to.point(*y)) <= rounded)
    }

    /// The p of a place of the second element on a course, if it is there.
    pub(super) fn parameter(&self, course: &Course, place: &Motion) -> Option<f64> {
        let aside = ROUNDED.max(NEGLIGIBLE * self.tolerance) * self.extent;
        course.parameter(place, &self.elements[1].hull, aside)
    }
}
