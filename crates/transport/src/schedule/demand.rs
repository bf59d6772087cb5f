//! The blocks that are asked for.

use radiosity_elements::Elements;
use radiosity_kernel::Accuracy;
use radiosity_visibility::Visibility;

/// Treatment of pairs whose accuracy the rules do not reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unreached {
    /// The pairs are stored, and their error is told.
    Kept,
    /// The pairs are left to rays; so are shadows of curved things, without a try.
    Left,
}

impl Unreached {
    /// The treatment where all pairs are asked of the rules: rays carry the rest, if surfaces hide each
    /// other.
    pub(crate) fn of(visibility: &Visibility) -> Self {
        if visibility.casts() { Self::Left } else { Self::Kept }
    }
}

/// The pairs of elements whose blocks are asked for, and how accurate these have to be.
#[derive(Clone, Copy)]
pub(crate) struct Demand<'a> {
    pub elements: &'a Elements,
    /// Whether the block of two elements, in ascending order, is asked for.
    pub wanted: &'a (dyn Fn(usize, usize) -> bool + Sync),
    pub visibility: &'a Visibility,
    pub accuracy: Accuracy,
    pub unreached: Unreached,
}
