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

/// Things between which view factors are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FactorEnds {
    /// Single elements.
    Element,
    /// Surfaces.
    Surface,
}

/// The pairs of elements whose blocks are asked for, and how accurate these have to be.
#[derive(Clone, Copy)]
pub struct Demand<'a> {
    /// The elements.
    pub elements: &'a Elements,
    /// Whether the block of two elements, in ascending order, is asked for.
    pub wanted: &'a (dyn Fn(usize, usize) -> bool + Sync),
    /// Visibility between the elements.
    pub visibility: &'a Visibility,
    /// Accuracy of the blocks.
    pub accuracy: Accuracy,
    /// Things whose view factors have to be accurate where rays carry blocks.
    pub whole: FactorEnds,
}

impl<'a> Demand<'a> {
    /// All pairs, accurate for the view factors of elements.
    pub fn all(elements: &'a Elements, visibility: &'a Visibility, accuracy: Accuracy) -> Self {
        Self { elements, wanted: &|_, _| true, visibility, accuracy, whole: FactorEnds::Element }
    }
    /// The pairs that are `wanted` of it: a question about two elements, in ascending order.
    pub fn of(self, wanted: &'a (dyn Fn(usize, usize) -> bool + Sync)) -> Self {
        Self { wanted, ..self }
    }
}
