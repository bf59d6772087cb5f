//! The blocks that were integrated, each on one rank, and their way to the ranks that hold their rows and
//! columns.

use std::sync::Arc;

use radiosity_kernel::blocks::block::{Block, BlockReport};
use radiosity_kernel::blocks::held_rows::HeldRows;
use radiosity_work::ranks::{Part, PartName, Ranks};
use serde::{Deserialize, Serialize};

use crate::kept_blocks::IntegratedBlock;
use crate::schedule::balance::{Balance, WorkItem, rounds};
use crate::schedule::plan::Planned;

/// A block as all ranks know it, without its values.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct IntegratedReport {
    pub(super) block: BlockReport,
    /// Largest absolute value; NaN if one of them is.
    pub(super) largest: f64,
    /// Bound of the norm of the block's difference from the integrated one ([`IntegratedBlock::remainder`]).
    pub(super) remainder: f64,
}

impl IntegratedReport {
    fn of(block: &Arc<IntegratedBlock>) -> Self {
        Self { block: block.block.report, largest: block.block.largest(), remainder: block.remainder }
    }
}

/// The blocks that were integrated.
#[derive(Debug)]
pub(super) struct Integrated {
    pub(super) ranks: Ranks,
    /// The rank that made each of them.
    pub(super) makers: Vec<usize>,
    reports: Vec<Option<IntegratedReport>>,
    /// Blocks that this rank made, and after [`Integrated::deliver`] those that it needs.
    blocks: Vec<Option<Arc<IntegratedBlock>>>,
}

impl Integrated {
    /// The blocks that `make` makes of these pieces of work, shared between ranks by what pieces cost.
    pub(super) fn made(
        ranks: Ranks,
        items: &[WorkItem],
        make: impl Fn(usize) -> Arc<IntegratedBlock> + Sync,
    ) -> Self {
        let mut balance = Balance::new(ranks.count());
        let mut all = Self::none(ranks.clone(), items.len());
        let part = ranks.part(PartName::Blocks, items.len());
        for round in rounds(items.len(), ranks.count()) {
            let makers = balance.share(&round, items);
            all.make(&part, &round, &makers, &make);
            for (place, maker) in round.into_iter().zip(makers) {
                balance.take(maker, &items[place], &all.report(place).block);
            }
        }
        all
    }

    /// The blocks that `make` makes where the rank `makers[place]` makes each one, and none is recorded: what
    /// makes it depends on what that rank made before.
    pub(super) fn made_by(
        ranks: Ranks,
        makers: &[usize],
        make: impl Fn(usize) -> Arc<IntegratedBlock> + Sync,
    ) -> Self {
        let mut all = Self::none(ranks, makers.len());
        let places: Vec<usize> = (0..makers.len()).collect();
        all.make(&Part::unrecorded(), &places, makers, &make);
        all
    }

    /// Blocks that one rank made, as far as they are.
    pub(super) fn found(ranks: Ranks, blocks: Vec<Option<Arc<IntegratedBlock>>>) -> Self {
        let reports = blocks.iter().map(|block| block.as_ref().map(IntegratedReport::of)).collect();
        Self { makers: vec![0; blocks.len()], reports, blocks, ranks }
    }

    /// None of so many blocks yet.
    fn none(ranks: Ranks, count: usize) -> Self {
        Self { makers: vec![0; count], reports: vec![None; count], blocks: vec![None; count], ranks }
    }

    /// Makes the blocks at these places, each on the rank in `makers`.
    fn make(
        &mut self,
        part: &Part,
        places: &[usize],
        makers: &[usize],
        make: &(impl Fn(usize) -> Arc<IntegratedBlock> + Sync),
    ) {
        let me = self.ranks.number();
        let own = places.iter().zip(makers).filter(|(_, maker)| **maker == me);
        let made = part.made(&own.map(|(place, _)| *place).collect::<Vec<_>>(), make);
        let reports = self.ranks.merged(makers, made.iter().map(IntegratedReport::of).collect());
        let mut made = made.into_iter();
        for ((place, maker), report) in places.iter().zip(makers).zip(reports) {
            self.makers[*place] = *maker;
            self.reports[*place] = Some(report);
            self.blocks[*place] = (*maker == me).then(|| made.next()).flatten();
        }
    }

    /// The block at `place`, as all ranks know it.
    pub(super) fn report(&self, place: usize) -> &IntegratedReport {
        self.reports[place].as_ref().expect("all blocks were made")
    }

    /// Sends the values of each block to the ranks that hold its row or its column; to all ranks where the
    /// task of this number `is_left`.
    pub(super) fn deliver(&mut self, plan: &[Planned], is_left: &dyn Fn(usize) -> bool, held: &HeldRows) {
        if self.ranks.are_alone() {
            return;
        }
        let me = self.ranks.number();
        let mut wanted: Vec<(usize, usize)> = Vec::new();
        for (index, planned) in plan.iter().enumerate() {
            let place = planned.source.place();
            if self.makers[place] != me {
                continue;
            }
            match is_left(index) {
                true => wanted.extend((0..self.ranks.count()).map(|rank| (rank, place))),
                false => wanted.extend(planned.task.pair().map(|element| (held.rank(element), place))),
            }
        }
        wanted.sort_unstable();
        wanted.dedup();
        let mut parcels: Vec<Vec<(usize, Vec<f64>)>> = vec![Vec::new(); self.ranks.count()];
        for (rank, place) in wanted.into_iter().filter(|(rank, _)| *rank != me) {
            parcels[rank].push((place, self.values(place).to_vec()));
        }
        for (place, values) in self.ranks.exchange(parcels).into_iter().flatten() {
            let IntegratedReport { block: report, remainder, .. } = *self.report(place);
            let block = IntegratedBlock::known(Block { values, report }, remainder);
            self.blocks[place] = Some(Arc::new(block));
        }
    }

    /// A block that this rank made or was sent.
    pub(super) fn block(&self, place: usize) -> &IntegratedBlock {
        self.blocks[place].as_ref().expect("ranks have the blocks of their rows and columns")
    }

    /// The values of the block at `place`, row-major.
    pub(super) fn values(&self, place: usize) -> &[f64] {
        &self.block(place).block.values
    }
    /// The blocks that this rank made, in order; None in place of the others.
    pub(super) fn into_made(self) -> impl Iterator<Item = Option<Arc<IntegratedBlock>>> {
        let me = self.ranks.number();
        self.blocks.into_iter().zip(self.makers).map(move |(block, maker)| block.filter(|_| maker == me))
    }
}
