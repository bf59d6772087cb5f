//! Costs of the blocks of a scene, and shares of ranks in them.

use radiosity_elements::Elements;
use radiosity_kernel::blocks::held_rows::HeldRows;
use radiosity_kernel::{Accuracy, blocks::block::BlockReport};
use radiosity_visibility::Visibility;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;

pub use crate::schedule::balance::Cost;
use crate::schedule::balance::{Balance, WorkItem, rounds};
use crate::schedule::demand::{Demand, Unreached};
use crate::schedule::task::Schedule;

/// The work that a block was.
#[derive(Clone, Copy, Debug)]
pub struct BlockWork {
    item: WorkItem,
    report: BlockReport,
}

impl BlockWork {
    /// The cost of the block.
    pub fn cost(&self) -> Cost {
        Cost::of(&self.report)
    }
}

/// Integrates the blocks of all pairs of which at least one element `sends` light, and tells what each of
/// them cost.
pub fn work(
    elements: &Elements,
    sends: &(dyn Fn(usize) -> bool + Sync),
    visibility: &Visibility,
    accuracy: Accuracy,
) -> Vec<BlockWork> {
    let wanted = |a: usize, b: usize| sends(a) || sends(b);
    let demand = Demand::all(elements, visibility, accuracy).of(&wanted);
    let schedule = Schedule::new(demand, Unreached::of(visibility));
    let (tasks, _) = schedule.sort(Ranks::alone());
    let plan = schedule.plan(tasks);
    let held = HeldRows::of(Ranks::alone(), &elements.starts());
    let integrated = schedule.integrate(&plan, None, &held, &Work::alone());
    let own = plan.iter().filter(|planned| planned.source.is_own()).enumerate();
    own.map(|(place, planned)| BlockWork {
        item: schedule.item(&planned.task),
        report: integrated.report(place).block,
    })
    .collect()
}

/// Cost of the blocks of each of so many ranks that share this work, round by round: ranks wait for each
/// other between rounds.
pub fn shared(work: &[BlockWork], ranks: usize) -> Vec<Vec<Cost>> {
    let items: Vec<WorkItem> = work.iter().map(|work| work.item).collect();
    let mut balance = Balance::new(ranks);
    let round = |round: Vec<usize>| {
        let mut done = vec![Cost::default(); ranks];
        let makers = balance.share(&round, &items);
        for (place, maker) in round.into_iter().zip(makers) {
            balance.take(maker, &items[place], &work[place].report);
            done[maker] += work[place].cost();
        }
        done
    };
    rounds(items.len(), ranks).into_iter().map(round).collect()
}
