//! From elements to blocks: every unordered pair is sorted, equal pairs are found, and each distinct pair is
//! integrated once.
//!
//! Sorting drops the pairs behind each other, in one plane, wholly hidden, or without a sender, many at once
//! where it can ([`crate::schedule::groups`]). Pairs equal
//! up to similarity ([`crate::schedule::congruent`]) share the block of the first of them. A block that is
//! small compared with its row is integrated to a lower relative accuracy
//! ([`radiosity_kernel::estimates::entry_bounds`]). The result does not depend on the order in which the
//! threads work.

pub(crate) mod order;
mod congruent;
mod demand;
mod task;
mod balance;
mod goal;
mod plan;
mod groups;
mod sorting;
mod integrated;
mod integration;
mod kept;
mod work;
mod columns_as_shot;

use radiosity_kernel::blocks::block::BlockReport;
use radiosity_kernel::estimates::entry_bounds::{ROW_SHARE, SMALLEST_ENTRY};
use radiosity_kernel::{Accuracy, Blocks, PairKind, Remainder, WorstError};
use radiosity_work::Work;
use radiosity_work::interruption::check_interrupt;

use crate::kept_blocks::KeptBlocks;
pub use columns_as_shot::ColumnsAsShot;
pub(crate) use demand::Unreached;
pub use demand::{Demand, FactorEnds};
use integrated::{Integrated, IntegratedReport};
use plan::{Planned, Source};
use task::{Schedule, Task};
pub use work::{BlockWork, Cost, shared, work};

/// A pair whose block the rules did not reach.
#[derive(Debug)]
pub(crate) struct UnreachedPair {
    pub row: usize,
    pub column: usize,
    /// The block by rules, where they made one.
    pub by_rules: Option<BlockByRules>,
    /// Whether shadows are a part of it.
    pub partly_hidden: bool,
}

/// A block as the rules find it.
#[derive(Debug)]
pub(crate) struct BlockByRules {
    /// Row-major, receiver functions by emitter functions.
    pub values: Vec<f64>,
    /// Largest error of an entry, as far as the rules know it.
    pub error: f64,
}

/// The error that the rules leave in the block of a task, and whether they carry it.
struct RuleOutcome {
    /// Relative to the largest of: its largest entry, a hundredth of its row's, and 1e-8.
    error: f64,
    /// Whether it is left to rays.
    is_left: bool,
}

/// The blocks of a demand, by rules, and the pairs that these leave; what `kept` holds, which was moved to
/// this scene, is not integrated again.
pub(crate) fn by_rules(
    demand: Demand,
    unreached: Unreached,
    kept: Option<&mut KeptBlocks>,
    work: &Work<'_>,
) -> (Blocks, Vec<UnreachedPair>) {
    let schedule = Schedule::new(demand, unreached);
    let mut blocks = Blocks::empty(demand.elements.starts(), true, work.ranks);
    let (tasks, pairs) = schedule.sort(work.ranks);
    if pairs.skipped_black > 0 {
        schedule.open_rows().into_iter().for_each(|row| blocks.leave_open(row));
    }
    blocks.statistics.pairs = pairs;
    let plan = schedule.plan(tasks);
    let mut integrated = schedule.integrate(&plan, kept.as_deref(), blocks.held(), work);
    let left = schedule.gather(&mut blocks, &plan, &mut integrated);
    if let Some(kept) = kept {
        let own = plan.iter().filter(|planned| planned.source.is_own());
        let requests = own.map(|Planned { task, goal, .. }| goal.request(task, demand.visibility));
        let made =
            requests.zip(integrated.into_made()).filter_map(|(request, block)| Some((request, block?)));
        kept.replace(made.collect(), work.ranks);
    }
    (blocks, left)
}

impl Schedule<'_> {
    /// Stores the blocks of a plan with their statistics, and returns the pairs that are left to rays.
    fn gather(
        &self,
        blocks: &mut Blocks,
        plan: &[Planned],
        integrated: &mut Integrated,
    ) -> Vec<UnreachedPair> {
        let outcomes = self.outcomes(plan, integrated);
        integrated.deliver(plan, &|index| outcomes[index].is_left, blocks.held());
        self.store(blocks, plan, &outcomes, integrated)
    }

    /// The errors of all blocks, and whether rules or rays carry them.
    fn outcomes(&self, plan: &[Planned], integrated: &Integrated) -> Vec<RuleOutcome> {
        let mut rows = vec![0.0f64; self.list.len()];
        for Planned { task, source, .. } in plan {
            let most = integrated.report(source.place()).largest;
            for element in [task.row, task.column] {
                rows[element as usize] = rows[element as usize].max(most);
            }
        }
        let outcome = |Planned { task, source, .. }: &Planned| {
            let IntegratedReport { block, largest, .. } = integrated.report(source.place());
            let row = rows[task.row as usize].min(rows[task.column as usize]);
            let error = block.error / largest.max(ROW_SHARE * row).max(SMALLEST_ENTRY);
            RuleOutcome { error, is_left: block.untried || error > self.accuracy.eps && self.is_left(task) }
        };
        plan.iter().map(outcome).collect()
    }

    /// Whether a block that misses the accuracy is left to others: rules of flat elements between which
    /// nothing, or flat things only, stand know their errors better.
    fn is_left(&self, task: &Task) -> bool {
        let is_flat = |element: u32| self.list[element as usize].plane.is_some();
        let are_flat = is_flat(task.row) && is_flat(task.column);
        self.unreached == Unreached::Left && !(are_flat && self.casts_flat_shadows(task))
    }

    /// Whether nothing stands between the elements of a task but what has an outline.
    fn casts_flat_shadows(&self, task: &Task) -> bool {
        self.visibility.are_planar(&task.blockers) || self.has_outlines(task)
    }

    /// Stores the blocks of all tasks with their costs and errors, and returns those that are left to rays.
    fn store(
        &self,
        blocks: &mut Blocks,
        plan: &[Planned],
        outcomes: &[RuleOutcome],
        integrated: &Integrated,
    ) -> Vec<UnreachedPair> {
        let mut left = Vec::new();
        for (planned, RuleOutcome { error, is_left }) in plan.iter().zip(outcomes) {
            check_interrupt();
            let place = planned.source.place();
            let block = integrated.report(place).block;
            let pair @ [row, column] = planned.task.pair();
            blocks.statistics.pairs.take(&block);
            if *is_left {
                debug_assert!(planned.source.is_own(), "only flat pairs that nothing hides are copies");
                let values = (!block.untried).then(|| integrated.values(place).to_vec());
                let by_rules = values.map(|values| BlockByRules { values, error: block.error });
                left.push(UnreachedPair { row, column, by_rules, partly_hidden: block.partly_hidden });
                blocks.statistics.pairs.unresolved -= usize::from(block.unresolved);
                blocks.statistics.take_costs(&block);
                continue;
            }
            let asked = asked(block.partly_hidden, self.accuracy);
            blocks.statistics.record_error(WorstError { pair, error: *error, asked, by_rays: false });
            let unit = (self.list[row].area * self.list[column].area).sqrt();
            let untold = if is_exact(&block) { 0.0 } else { integrated.report(place).largest - block.told };
            let exchange = unit * asked * untold.max(0.0);
            blocks.statistics.take_exchange(pair, self.list.len(), unit * block.error, exchange);
            self.push(blocks, planned, integrated);
        }
        left
    }

    /// Stores the block of a task and adds its cost.
    fn push(&self, blocks: &mut Blocks, planned: &Planned, integrated: &Integrated) {
        let Planned { task, source, .. } = planned;
        let place = source.place();
        let IntegratedReport { block, largest, remainder } = integrated.report(place);
        let places @ [row, column] = task.pair();
        if *remainder > 0.0 {
            blocks.statistics.remainders.push(Remainder { places, bound: *remainder });
        }
        match source {
            Source::Own(_) => blocks.statistics.take_costs(block),
            Source::Copy { .. } => {
                blocks.statistics.pairs.repeated += 1;
                blocks.statistics.samples += block.samples;
            }
        }
        match source {
            _ if *largest == 0.0 => {}
            _ if !blocks.holds(row, column) => blocks.pass(row, column),
            Source::Own(_) => blocks.push(row, column, integrated.values(place)),
            Source::Copy { first, .. } => {
                let values = self.copied(task.pair(), *first, integrated.values(place));
                blocks.push(row, column, &values);
            }
        }
    }
}

/// Whether a closed form made a block that nothing hides a part of.
fn is_exact(block: &BlockReport) -> bool {
    block.kind == PairKind::Contour && !block.partly_hidden
}

/// The error that is asked of a block: where something hides a part of it, that of shadows if larger.
pub(crate) fn asked(partly_hidden: bool, accuracy: Accuracy) -> f64 {
    if partly_hidden { accuracy.shadow_eps } else { 0.0 }.max(accuracy.eps)
}
