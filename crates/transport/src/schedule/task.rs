//! The elements with the data that sorting needs, and the pairs that are left to integrate.

use std::sync::OnceLock;

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_kernel::Accuracy;
use radiosity_kernel::contact::sectors::sectors;
use radiosity_kernel::estimates::coarse::CoarseEstimate;
use radiosity_kernel::estimates::entry_bounds::EntryBounds;
use radiosity_visibility::Visibility;
use serde::{Deserialize, Serialize};

use super::congruent::Panel;
use super::demand::{Demand, Unreached};
use super::order::Precedence;

/// The elements with the data that sorting needs.
pub(super) struct Schedule<'a> {
    pub(super) list: &'a [Element],
    pub(super) panels: Vec<Option<Panel>>,
    pub(super) bounds: Vec<EntryBounds>,
    pub(super) precedence: Vec<Precedence>,
    estimates: Vec<OnceLock<CoarseEstimate>>,
    /// Whether coarse estimates are needed: planar elements need them for shadows only.
    pub(super) is_estimated: bool,
    parts: Vec<OnceLock<Vec<Patch>>>,
    pub(super) visibility: &'a Visibility,
    pub(super) accuracy: Accuracy,
    pub(super) unreached: Unreached,
    pub(super) wanted: &'a (dyn Fn(usize, usize) -> bool + Sync),
}

impl<'a> Schedule<'a> {
    /// The elements between which the blocks of a demand are to be found.
    pub(super) fn new(demand: Demand<'a>, unreached: Unreached) -> Self {
        let Demand { elements, wanted, visibility, accuracy, .. } = demand;
        let list = elements.list();
        Self {
            list,
            panels: list.iter().map(Panel::of).collect(),
            bounds: list.iter().map(EntryBounds::of).collect(),
            precedence: list.iter().map(Precedence::of).collect(),
            estimates: list.iter().map(|_| OnceLock::new()).collect(),
            is_estimated: visibility.has_obstacles() || list.iter().any(|element| element.plane.is_none()),
            parts: list.iter().map(|_| OnceLock::new()).collect(),
            visibility,
            accuracy,
            unreached,
            wanted,
        }
    }

    /// The coarse estimate of an element, made when it is first asked for.
    pub(super) fn estimate_of(&self, element: usize) -> &CoarseEstimate {
        self.estimates[element].get_or_init(|| CoarseEstimate::of(&self.list[element]))
    }

    /// The sectors of an element, made when they are first asked for.
    pub(super) fn parts_of(&self, element: usize) -> &[Patch] {
        self.parts[element].get_or_init(|| sectors(&self.list[element]))
    }
}

/// A pair whose block is to be found.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Task {
    pub(super) row: u32,
    pub(super) column: u32,
    /// Bounds: the largest entry from below (an estimate for curved elements), all entries from above.
    pub(super) entries: [f64; 2],
    /// Coarse estimate of the first entry, without blockers; 0 where none was made.
    pub(super) estimate: f64,
    /// Hash of the pose, where the pair may be congruent to others.
    pub(super) hash: Option<u64>,
    /// Surfaces that may stand between the two.
    pub(super) blockers: Vec<usize>,
    /// The pair's own surfaces that may hide a part of it; whether they do is found by probing rays.
    pub(super) own: Vec<usize>,
}

impl Task {
    /// The task of two elements that lie on each other: the block is known.
    pub(super) fn of_contact(row: usize, column: usize) -> Self {
        Self {
            row: row as u32,
            column: column as u32,
            entries: [1.0; 2],
            estimate: 1.0,
            hash: None,
            blockers: Vec::new(),
            own: Vec::new(),
        }
    }

    /// Its elements.
    pub(super) fn pair(&self) -> [usize; 2] {
        [self.row as usize, self.column as usize]
    }
}
