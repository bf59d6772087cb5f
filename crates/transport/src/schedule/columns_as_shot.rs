//! Columns of G that are integrated when they are first asked for: the blocks of the whole matrix, to the bit,
//! as far as rules alone make it.
//!
//! Sorting and planning look at all pairs, as for the whole matrix: the accuracy that a block has to reach
//! depends on its rows. A block is then integrated when the column of either of its elements is first asked
//! for; pairs that are congruent share one. Rays, which stand in where rules miss the accuracy, judge
//! whole rows: they have no part in it, and what rules miss is told.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, OnceLock};
use std::time::{Duration, Instant};

use radiosity_kernel::block_columns::{BlockColumns, placed};
use radiosity_kernel::{Blocks, PairCounts, PlacedBlock};
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Stage, Work};
use rayon::prelude::*;

use crate::kept_blocks::IntegratedBlock;
use crate::schedule::demand::{Demand, Unreached};
use crate::schedule::integrated::Integrated;
use crate::schedule::plan::{Planned, Source};
use crate::schedule::task::Schedule;

/// Blocks that are integrated column by column, when one is first asked for.
pub struct ColumnsAsShot<'a> {
    schedule: Schedule<'a>,
    starts: Vec<usize>,
    plan: Vec<Planned>,
    /// The tasks of the plan in the column of each element.
    columns: Vec<Vec<usize>>,
    /// The task that each block is integrated for.
    owners: Vec<usize>,
    blocks: Vec<OnceLock<Arc<IntegratedBlock>>>,
    asked: Vec<AtomicBool>,
    pairs: PairCounts,
    seconds: Mutex<Duration>,
    work: Work<'a>,
}

impl<'a> ColumnsAsShot<'a> {
    /// Sorts and plans the pairs of a demand; integrates nothing.
    pub fn new(demand: Demand<'a>, work: Work<'a>) -> Self {
        let begun = Instant::now();
        let schedule = Schedule::new(demand, Unreached::Kept);
        let starts = demand.elements.starts();
        let (tasks, pairs) = schedule.sort(Ranks::alone());
        let plan = schedule.plan(tasks);
        let mut columns = vec![Vec::new(); starts.len() - 1];
        let mut owners = Vec::new();
        for (index, Planned { task, source, .. }) in plan.iter().enumerate() {
            let [row, column] = task.pair();
            columns[column].push(index);
            if row != column {
                columns[row].push(index);
            }
            if source.is_own() {
                owners.push(index);
            }
        }
        let blocks = owners.iter().map(|_| OnceLock::new()).collect();
        let asked = columns.iter().map(|_| AtomicBool::new(false)).collect();
        let seconds = Mutex::new(begun.elapsed());
        Self { schedule, starts, plan, columns, owners, blocks, asked, pairs, seconds, work }
    }

    /// Time spent on sorting and integration so far.
    pub fn seconds(&self) -> Duration {
        *self.seconds.lock().expect("nothing fails while it is held")
    }

    /// Integrates what the column of an element lacks.
    fn integrate(&self, element: usize) {
        if self.asked[element].swap(true, Ordering::Relaxed) {
            return;
        }
        let begun = Instant::now();
        let places = self.columns[element].iter().map(|index| self.plan[*index].source.place());
        let mut missing: Vec<usize> = places.filter(|place| self.blocks[*place].get().is_none()).collect();
        missing.sort_unstable();
        missing.dedup();
        self.work.during(Stage::Blocks, || missing.par_iter().for_each(|place| self.integrate_block(*place)));
        *self.seconds.lock().expect("nothing fails while it is held") += begun.elapsed();
    }

    fn integrate_block(&self, place: usize) {
        check_interrupt();
        let Planned { task, goal, .. } = &self.plan[self.owners[place]];
        self.blocks[place].get_or_init(|| {
            Arc::new(IntegratedBlock::of(self.schedule.block(self.schedule.is_turned(task), task, *goal)))
        });
    }

    /// The blocks of all columns that were asked for, as a matrix whose other rows are left open.
    pub fn into_blocks(self) -> Blocks {
        let Self { schedule, starts, plan, blocks: made, asked, pairs, .. } = self;
        let is_asked = |element: usize| asked[element].load(Ordering::Relaxed);
        let mut blocks = Blocks::empty(starts, true, Ranks::alone());
        let open = (0..asked.len()).filter(|element| !is_asked(*element));
        open.for_each(|element| blocks.leave_open(element));
        if pairs.skipped_black > 0 {
            schedule.open_rows().into_iter().for_each(|row| blocks.leave_open(row));
        }
        blocks.statistics.pairs = pairs;
        let plan: Vec<Planned> =
            plan.into_iter().filter(|planned| planned.task.pair().into_iter().any(is_asked)).collect();
        let made = made.into_iter().map(OnceLock::into_inner).collect();
        let mut integrated = Integrated::found(Ranks::alone().clone(), made);
        let left = schedule.gather(&mut blocks, &plan, &mut integrated);
        debug_assert!(left.is_empty(), "rules keep all pairs");
        blocks
    }
}

impl BlockColumns for ColumnsAsShot<'_> {
    fn starts(&self) -> &[usize] {
        &self.starts
    }

    fn column(&self, element: usize) -> Vec<PlacedBlock<'_>> {
        check_interrupt();
        self.integrate(element);
        let block = |index: &usize| {
            let Planned { task, source, .. } = &self.plan[*index];
            let values = &self.blocks[source.place()].get().expect("it was integrated").block.values;
            let pair @ [_, column] = task.pair();
            let columns = self.starts[column + 1] - self.starts[column];
            let is_transposed = column != element;
            match source {
                Source::Own(_) => placed(pair, values, columns, is_transposed),
                Source::Copy { first, .. } => {
                    let copy = self.schedule.copied(pair, *first, values);
                    let PlacedBlock { row, column, values } = placed(pair, &copy, columns, is_transposed);
                    PlacedBlock { row, column, values: values.into_owned().into() }
                }
            }
        };
        self.columns[element].iter().map(block).collect()
    }

    fn integrated(&self) -> usize {
        self.asked.iter().filter(|asked| asked.load(Ordering::Relaxed)).count()
    }
}
