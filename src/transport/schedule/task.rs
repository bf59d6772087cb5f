//! The elements of a scene with what sorting needs of them, and the pairs that are left to integrate.

use crate::elements::Element;
use crate::elements::patch::Patch;
use crate::transport::blocks::block::Accuracy;
use crate::transport::estimates::coarse::CoarseEstimate;
use crate::transport::estimates::entry_bounds::EntryBounds;
use crate::visibility::Visibility;

use super::congruent::Panel;
use super::order::Rank;

/// Elements with what sorting needs of them.
pub(super) struct Scene<'a> {
    pub(super) list: &'a [Element],
    pub(super) panels: Vec<Option<Panel>>,
    pub(super) reaches: Vec<EntryBounds>,
    pub(super) ranks: Vec<Rank>,
    pub(super) roughs: Vec<CoarseEstimate>,
    /// Whether blocks are estimated: what is planar needs it for its shadows only.
    pub(super) is_estimated: bool,
    /// The sectors of each.
    pub(super) parts: Vec<Vec<Patch>>,
    pub(super) visibility: &'a Visibility,
    pub(super) accuracy: Accuracy,
    pub(super) wanted: &'a (dyn Fn(usize, usize) -> bool + Sync),
}

/// A pair to integrate.
pub(super) struct Task {
    pub(super) row: u32,
    pub(super) column: u32,
    /// Bounds of its entries: the largest from below (an estimate for curved elements), all from above.
    pub(super) entries: [f64; 2],
    /// About its first entry, were nothing in between; 0 where nothing is estimated.
    pub(super) rough: f64,
    /// Hash of its pose where it may be equal to others.
    pub(super) hash: Option<u64>,
    /// Surfaces that may stand between.
    pub(super) blockers: Vec<usize>,
    /// Those of the pair that may hide a part of it themselves, if enough rays meet them.
    pub(super) own: Vec<usize>,
}

impl Task {
    /// Of two elements that cover each other: the block is known.
    pub(super) fn of_contact(row: usize, column: usize) -> Self {
        Self {
            row: row as u32,
            column: column as u32,
            entries: [1.0; 2],
            rough: 1.0,
            hash: None,
            blockers: Vec::new(),
            own: Vec::new(),
        }
    }
}
