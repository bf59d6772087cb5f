//! Pairs that are carried exactly beside the rays: those for which as good a block by rays would cost more.
//!
//! A pair that n rays meet has a relative error of about n^-½. An exact block removes it, for the time of a number of
//! rays that
//! depends on what the pair is. It is taken where fewer rays than that are expected to land on the pair: what is left
//! to the rays are
//! many weak pairs. Rays that land on a pair of these are not counted.

use std::borrow::Cow;
use std::collections::HashSet;

use crate::elements::Elements;
use crate::transport::blocks::Blocks;
use crate::transport::blocks::block::Accuracy;
use crate::transport::sampled::tally::{Sums, Tally};
use crate::transport::schedule::assemble_pairs;
use crate::visibility::Visibility;

/// Rays that take as long as the exact block of two flat elements with nothing between them; with something between;
/// and of elements of
/// which one is curved. From blocks of 50 µs, 2.5 ms and 20 ms, and a million rays a second.
const FREE: f64 = 50.0;
const PARTLY_HIDDEN: f64 = 2_500.0;
const CURVED: f64 = 20_000.0;

/// Most elements of a scene in which exact pairs are looked for: to sort all pairs takes a second then.
const MOST_ELEMENTS: usize = 5_000;

/// Pairs that are carried exactly, and their blocks.
#[derive(Debug, Default)]
pub(super) struct Strong {
    pairs: HashSet<(u32, u32)>,
    blocks: Option<Blocks>,
}

impl Strong {
    /// The pairs of `tally` that are worth it for the number of hits that is `expected` of them, with their blocks.
    pub(super) fn choose(
        elements: &Elements,
        visibility: &Visibility,
        tally: &Tally,
        expected: &dyn Fn(&Sums) -> f64,
        accuracy: Accuracy,
    ) -> Self {
        if elements.list().len() > MOST_ELEMENTS {
            return Self::default();
        }
        let is_worth = |sums: &Sums| {
            let expected = expected(sums);
            expected > FREE && expected > cost(elements, visibility, [sums.row, sums.column])
        };
        let pairs: HashSet<(u32, u32)> =
            tally.iter().filter(is_worth).map(|sums| (sums.row as u32, sums.column as u32)).collect();
        let wanted = |row: usize, column: usize| pairs.contains(&(row as u32, column as u32));
        let blocks =
            (!pairs.is_empty()).then(|| assemble_pairs(elements, &wanted, visibility, accuracy, &|_, _| {}));
        Self { pairs, blocks }
    }

    /// Whether the pair of two elements is carried exactly.
    pub(super) fn holds(&self, first: u32, second: u32) -> bool {
        self.pairs.contains(&(first.min(second), first.max(second)))
    }

    /// Number of pairs.
    pub(super) fn len(&self) -> usize {
        self.pairs.len()
    }

    /// Adds what the exact blocks cost, and what they miss, to the accounts of `blocks`.
    pub(super) fn add_accounts(&self, blocks: &mut Blocks) {
        if let Some(exact) = &self.blocks {
            (blocks.pairs, blocks.samples, blocks.distinct) = (exact.pairs, exact.samples, exact.distinct);
            (blocks.reciprocity, blocks.accuracy_reached) = (exact.reciprocity, exact.accuracy_reached);
        }
    }

    /// The exact blocks: the element that comes first, the other, and the values, row-major.
    pub(super) fn iter(&self) -> impl Iterator<Item = (usize, usize, Cow<'_, [f64]>)> {
        self.blocks.iter().flat_map(Blocks::iter)
    }
}

/// About how many rays take as long as the exact block of a pair.
fn cost(elements: &Elements, visibility: &Visibility, pair: [usize; 2]) -> f64 {
    let [a, b] = pair.map(|index| &elements.list()[index]);
    if a.plane.is_none() || b.plane.is_none() {
        CURVED
    } else if visibility.candidates(&a.hull, &b.hull, [a.surface, b.surface]).is_empty() {
        FREE
    } else {
        PARTLY_HIDDEN
    }
}
