//! The blocks of tasks: each by its rules, or as probing rays find it.

use std::borrow::Cow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_kernel::PairKind;
use radiosity_kernel::blocks::block::Block;
use radiosity_kernel::blocks::held_rows::HeldRows;
use radiosity_kernel::estimates::probing_rays::{Hidden, ProbingRays};
use radiosity_kernel::rules::covering;
use radiosity_work::{Stage, Work};

use crate::coaxial::{self, Between};
use crate::kept_blocks::{IntegratedBlock, KeptBlocks};
use crate::occlusion::outlines::occluded_block;
use crate::pair::{curved, flat};
use crate::price;
use crate::schedule::balance::WorkItem;
use crate::schedule::demand::Unreached;
use crate::schedule::goal::Goal;
use crate::schedule::integrated::Integrated;
use crate::schedule::plan::Planned;
use crate::schedule::task::{Schedule, Task};
use crate::tolerances::RULE_OF_THREE;

/// Fewest rays that count as a probe: they bound the visible part by 3/16.
const FEWEST_RAYS: u64 = 16;
/// Most probing rays for the blockers of a pair, some hundredths of a second; where more were needed the
/// block samples them itself.
const MOST_RAYS: f64 = 2e4;
/// Probing rays that find whether surfaces hide themselves in that case: they bound what is missed by 3/4000.
const MOST_OWN_RAYS: f64 = 4e3;

impl Schedule<'_> {
    /// Integrates the tasks that are not copies, as far as `kept` does not hold their blocks; each rank
    /// some of them.
    ///
    /// Where blocks are kept, the rank that holds the row of a block integrates it in every scene: it has the
    /// block of the scene before.
    pub(super) fn integrate(
        &self,
        plan: &[Planned],
        kept: Option<&KeptBlocks>,
        held: &HeldRows,
        work: &Work<'_>,
    ) -> Integrated {
        let own: Vec<&Planned> = plan.iter().filter(|planned| planned.source.is_own()).collect();
        let (done, total) = (AtomicUsize::new(0), own.len());
        let ranks = work.ranks;
        let block = |place: usize| {
            let Planned { task, goal, .. } = own[place];
            let known = kept.and_then(|kept| self.kept_block(task, *goal, kept));
            let block = known.unwrap_or_else(|| {
                let block = self.block(self.is_turned(task), task, *goal);
                ranks.count_work(block.report.samples, block.report.rays);
                Arc::new(IntegratedBlock::of(block))
            });
            // Others do about as much in the same time.
            let done = ranks.count() * (done.fetch_add(1, Ordering::Relaxed) + 1);
            work.report_done(Stage::Blocks, done.min(total), total);
            block
        };
        if kept.is_some() {
            let makers: Vec<usize> = own.iter().map(|planned| held.rank(planned.task.row as usize)).collect();
            return Integrated::made_by(ranks.clone(), &makers, block);
        }
        let items: Vec<WorkItem> = own.iter().map(|planned| self.item(&planned.task)).collect();
        Integrated::made(ranks.clone(), &items, block)
    }

    /// The work of a task: its class and price.
    pub(super) fn item(&self, task: &Task) -> WorkItem {
        let ends @ [row, column] = task.pair();
        let are_flat = ends.iter().all(|element| self.list[*element].plane.is_some());
        let is_near = row == column || self.bounds[row].is_near(&self.bounds[column]);
        let are_constant = ends.iter().all(|element| self.list[*element].basis.len() == 1);
        let bits = [are_flat, is_near, row == column, task.own.is_empty()];
        let bits = bits.iter().fold(0, |bits, bit| 2 * bits + u64::from(*bit));
        let class = 16 * task.blockers.len() as u64 + bits;
        let price = price::of_blockers(are_flat, are_constant, &task.blockers, self.visibility);
        WorkItem { class, price }
    }

    /// The block of a task; where it is `turned`, the outer integral is over the emitter.
    pub(super) fn block(&self, turned: bool, task: &Task, goal: Goal) -> Block {
        let places @ [row, column] = task.pair();
        if turned {
            let rows = self.list[column].basis.len();
            return self.block_of([column, row], task, goal).turned(rows);
        }
        self.block_of(places, task, goal)
    }

    /// Whether the outer integral of a task is over its emitter ([`crate::schedule::order`]). Flat elements
    /// without blockers give the same block either way.
    pub(super) fn is_turned(&self, task: &Task) -> bool {
        let [row, column] = task.pair();
        let is_flat = [row, column].iter().all(|index| self.list[*index].plane.is_some());
        let is_alike = is_flat && task.blockers.is_empty();
        !is_alike && self.comes_later(row, column)
    }

    /// The block of a task between two elements, the outer one first.
    fn block_of(&self, places: [usize; 2], task: &Task, goal: Goal) -> Block {
        let pair @ [receiver, emitter] = places.map(|index| &self.list[index]);
        if receiver.contact.is_some() {
            return covering::block(receiver, emitter);
        }
        let between = Between { blockers: &task.blockers, own: &task.own };
        if let Some(block) = coaxial::block(pair, between, self.visibility, goal.accuracy.eps) {
            return block;
        }
        let is_flat = pair.iter().all(|element| element.plane.is_some());
        let block = |blockers: &[usize]| match is_flat {
            true => flat::block(receiver, emitter, blockers, self.visibility, goal.tolerance()),
            false => self.curved_block(places, task, blockers, goal),
        };
        match goal.outlined {
            Some(limit) => occluded_block(pair, &task.blockers, self.visibility, limit, || block(&[])),
            None if is_flat => self.hidden_block(places, task, goal).unwrap_or_else(|| {
                if self.unreached == Unreached::Left && !self.casts_flat_shadows(task) {
                    return Block::untried(self.size(places), PairKind::Separated, 0);
                }
                block(&task.blockers)
            }),
            None => block(&task.blockers),
        }
    }

    /// The block of two elements of which at least one is curved. If no probing ray is hidden, the blockers
    /// are ignored; if all are, the block is zero. Of the elements' own surfaces only those that hide some
    /// probing ray count as blockers.
    fn curved_block(&self, [row, column]: [usize; 2], task: &Task, blockers: &[usize], goal: Goal) -> Block {
        let (receiver, emitter) = (&self.list[row], &self.list[column]);
        let enough = (RULE_OF_THREE * task.estimate / goal.unseen).max(FEWEST_RAYS as f64);
        let is_told = enough <= MOST_RAYS;
        let asked = if is_told { blockers } else { &[] };
        let (mut blockers, mut rays) = (Cow::Borrowed(blockers), 0);
        if !asked.is_empty() || !task.own.is_empty() {
            let parts = [self.parts_of(row), self.parts_of(column)];
            let surfaces = [receiver.surface, emitter.surface];
            let most = if is_told { enough } else { MOST_OWN_RAYS };
            let met = ProbingRays::between(parts, surfaces, asked, &task.own, self.visibility, most);
            rays = met.rays;
            match (is_told && rays as f64 >= enough, met.hidden) {
                (true, Hidden::All) => {
                    return Block::hidden(self.size([row, column]), rays);
                }
                (true, Hidden::None) => blockers = Cow::Borrowed(&[]),
                _ => blockers.to_mut().extend(met.own),
            }
        }
        // Rays that pass do not tell enough of the ends of a can, and what else lies behind all that is seen.
        let stands =
            |blocker: &usize| !self.visibility.hides_nothing(*blocker, [receiver.surface, emitter.surface]);
        if blockers.iter().any(|blocker| !stands(blocker)) {
            blockers.to_mut().retain(stands);
        }
        // What a ball hides of a surface from itself is not known well enough either.
        let is_ball = row != column && self.visibility.only_ball(&blockers).is_some();
        let is_near = self.bounds[row].is_near(&self.bounds[column]);
        if self.unreached == Unreached::Left && is_near && !blockers.is_empty() && !is_ball {
            let kind = if row == column { PairKind::Same } else { PairKind::Separated };
            return Block::untried(self.size([row, column]), kind, rays);
        }
        let tolerance = goal.tolerance_of_curved(&blockers);
        let mut block = if row == column {
            curved::self_block(receiver, &blockers, self.visibility, tolerance)
        } else {
            curved::block(receiver, emitter, &blockers, self.visibility, tolerance)
        };
        block.report.rays += rays;
        block
    }

    /// The zero block of two flat elements if all probing rays are hidden. None if one passes, or if there
    /// are too few rays to bound what is visible.
    fn hidden_block(&self, [receiver, emitter]: [usize; 2], task: &Task, goal: Goal) -> Option<Block> {
        if task.blockers.is_empty() {
            return None;
        }
        let sees = |x, y| self.visibility.free(&task.blockers, x, y);
        let rays = self.estimate_of(receiver).hidden_rays(self.estimate_of(emitter), &sees)?;
        let is_told = rays >= FEWEST_RAYS && RULE_OF_THREE * task.estimate <= goal.unseen * rays as f64;
        is_told.then(|| Block::hidden(self.size([receiver, emitter]), rays))
    }
    /// Number of entries of the block of two elements.
    fn size(&self, pair: [usize; 2]) -> usize {
        pair.iter().map(|element| self.list[*element].basis.len()).product()
    }
}
