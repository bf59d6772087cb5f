//! Pairs that are carried exactly beside the rays: those for which as good a block by rays would cost more.
//!
//! A pair that n rays meet has a relative error of about n^-½. An exact block removes it, for the time of a
//! number of rays that depends on what the pair is. It is taken where more rays than that are expected to
//! land on the pair: what is left to the rays are many weak pairs. Rays that land on a pair of these are not
//! counted.

use std::collections::HashSet;

use radiosity_elements::{Element, Elements};
use radiosity_kernel::blocks::held_rows::HeldRows;
use radiosity_kernel::{Accuracy, BlockStatistics, Blocks};
use radiosity_visibility::Visibility;
use radiosity_work::Work;
use radiosity_work::interruption::check_interrupt;

use crate::kept_blocks::KeptBlocks;
use crate::price::{ElementPair, LEAST, price_up_to};
use crate::sampled::tally::{Sums, Tally};
use crate::schedule::{Demand, Unreached, by_rules};

/// Most elements of a scene in which exact pairs are looked for: to sort all pairs takes a second then.
const MOST_ELEMENTS: usize = 5_000;

/// Pairs that are carried exactly, and their blocks.
#[derive(Debug, Default)]
pub(super) struct ExactPairs {
    pairs: HashSet<(u32, u32)>,
    blocks: Option<Blocks>,
}

impl ExactPairs {
    /// The pairs of `tally`, of which each rank judges those in its rows, that are worth it for the number of
    /// hits that is `expected` of them.
    pub(super) fn worth(
        elements: &Elements,
        visibility: &Visibility,
        tally: &Tally,
        held: &HeldRows,
        expected: &dyn Fn(&Sums) -> f64,
    ) -> HashSet<(u32, u32)> {
        if elements.list().len() > MOST_ELEMENTS {
            return HashSet::new();
        }
        let is_worth = |sums: &Sums| {
            check_interrupt();
            let expected = expected(sums);
            expected > LEAST
                && expected
                    > price_up_to(expected, &element_pair(elements, [sums.row, sums.column]), visibility)
        };
        let own = tally.iter().filter(|sums| held.has(sums.row)).filter(is_worth);
        let own: Vec<(u32, u32)> = own.map(|sums| (sums.row as u32, sums.column as u32)).collect();
        held.ranks().all(own).into_iter().flatten().collect()
    }

    /// The exact pairs with their exact blocks, from `kept` as far as it holds them, without those whose
    /// accuracy rules do not reach.
    pub(super) fn new(
        mut pairs: HashSet<(u32, u32)>,
        elements: &Elements,
        visibility: &Visibility,
        accuracy: Accuracy,
        kept: Option<&mut KeptBlocks>,
        work: &Work<'_>,
    ) -> Self {
        if pairs.is_empty() {
            kept.into_iter().for_each(|kept| kept.replace(Vec::new(), work.ranks));
            return Self::default();
        }
        // All pairs of elements are asked for.
        let count = elements.list().len();
        let mut marks = vec![false; count * count];
        pairs.iter().for_each(|(row, column)| marks[*row as usize * count + *column as usize] = true);
        let wanted = |row: usize, column: usize| marks[row * count + column];
        let demand = Demand::all(elements, visibility, accuracy).of(&wanted);
        let (blocks, left) = by_rules(demand, Unreached::Left, kept, work);
        for pair in left {
            pairs.remove(&(pair.row as u32, pair.column as u32));
        }
        Self { pairs, blocks: Some(blocks) }
    }

    /// Whether a pair is carried exactly, the element that comes first in front.
    pub(super) fn holds(&self, pair: (u32, u32)) -> bool {
        self.pairs.contains(&pair)
    }

    /// The pairs.
    pub(super) fn pairs(&self) -> &HashSet<(u32, u32)> {
        &self.pairs
    }

    /// Largest error of the exact blocks, as [`BlockStatistics::accuracy_reached`].
    pub(super) fn accuracy_reached(&self) -> f64 {
        self.blocks.as_ref().map_or(0.0, |blocks| blocks.statistics.accuracy_reached)
    }

    /// Number of pairs.
    pub(super) fn len(&self) -> usize {
        self.pairs.len()
    }

    /// Statistics of `blocks`: what the exact blocks cost, without rays, and what they miss.
    pub(super) fn add_reports(&self, blocks: &mut Blocks) {
        if let Some(exact) = &self.blocks {
            blocks.statistics =
                BlockStatistics { rays: 0, remainders: Vec::new(), ..exact.statistics.clone() };
        }
    }

    /// Appends the exact blocks to `blocks`.
    pub(super) fn append_to(&self, blocks: &mut Blocks) {
        self.blocks.iter().for_each(|exact| blocks.append(exact));
    }
}

/// Two elements whose block may be made.
fn element_pair(elements: &Elements, pair: [usize; 2]) -> ElementPair<'_> {
    let pair @ [a, b] = pair.map(|index| &elements.list()[index]);
    let is_whole = |own: &Element| own.basis.len() == 1 && elements.of_surface(own.surface).len() == 1;
    ElementPair {
        surfaces: [a.surface, b.surface],
        hulls: [&a.hull, &b.hull],
        are_flat: a.plane.is_some() && b.plane.is_some(),
        are_constant: pair.iter().all(|own| own.basis.len() == 1),
        are_whole: pair.iter().all(|own| is_whole(own)),
    }
}
