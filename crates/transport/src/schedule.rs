//! From elements to blocks: every unordered pair is sorted, equal pairs are found, and each distinct pair is
//! integrated once.
//!
//! Sorting drops the pairs behind each other, in one plane, wholly hidden, or without a sender. Pairs equal
//! up to similarity ([`crate::schedule::congruent`]) share the block of the first of them. A block that is
//! small compared with its row is integrated to a lower relative accuracy
//! ([`radiosity_kernel::estimates::entry_bounds`]). The result does not depend on the order in which the
//! threads work.

pub(crate) mod order;
mod congruent;
mod demand;
mod task;
mod balance;
mod source;
mod work;
mod goal;
mod integrated;
mod kept;

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_kernel::Blocks;
use radiosity_kernel::PairCounts;
use radiosity_kernel::Reciprocity;
use radiosity_kernel::Remainder;
use radiosity_kernel::WorstError;
use radiosity_kernel::blocks::held_rows::HeldRows;
use radiosity_kernel::contact::planes;
use radiosity_kernel::contact::planes::Planes;
use radiosity_kernel::estimates::entry_bounds::{ROW_SHARE, SMALLEST_ENTRY};
use radiosity_kernel::estimates::probing_rays::{Hidden, ProbingRays};
use radiosity_kernel::rules::covering;
use radiosity_kernel::{
    PairKind,
    blocks::block::{Block, BlockReport},
};
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::{PartName, Ranks};
use radiosity_work::{Stage, Work};
use rayon::prelude::*;

use crate::kept_blocks::{IntegratedBlock, KeptBlocks};
use crate::occlusion::outlines::occluded_block;
use crate::pair::{curved, flat};
use crate::price;
use crate::schedule::congruent::Pose;
use crate::tolerances::{BELOW_ESTIMATE, RULE_OF_THREE};
use balance::WorkItem;
pub(crate) use demand::{Demand, Unreached};
use goal::Goal;
use integrated::{Integrated, IntegratedReport};
use source::Source;
use task::{Schedule, Task};
pub use work::{BlockWork, Cost, shared, work};

/// Share of a pair assumed visible, for its lower bound, where blockers may hide some of it. An assumption:
/// with a larger value rows that are nearly all hidden get too coarse a scale, with a smaller one the blocks
/// of most rows get more digits than they need.
const VISIBLE_SHARE: f64 = 0.1;

/// Fewest rays that count as a probe: they bound the visible part by 3/16.
const FEWEST_RAYS: u64 = 16;
/// Most probing rays for the blockers of a pair, some hundredths of a second; where more were needed the
/// block samples them itself.
const MOST_RAYS: f64 = 2e4;
/// Probing rays that find whether surfaces hide themselves in that case: they bound what is missed by 3/4000.
const MOST_OWN_RAYS: f64 = 4e3;

/// Pairs for each one that is integrated both ways, which costs a hundredth more.
const SAMPLED_SHARE: usize = 100;
/// Fewest pairs that are integrated both ways, in small scenes.
const FEWEST_SAMPLED: usize = 4;

/// Decisions of sorting about a pair.
enum Sorted {
    Behind,
    Coplanar,
    Hidden,
    Black,
    Task(Task),
}

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

/// The blocks of a demand, by rules, and the pairs that these leave; what `kept` holds, which was moved to
/// this scene, is not integrated again.
pub(crate) fn by_rules(
    demand: Demand,
    kept: Option<&mut KeptBlocks>,
    work: &Work<'_>,
) -> (Blocks, Vec<UnreachedPair>) {
    let Demand { elements, visibility, accuracy, .. } = demand;
    let list = elements.list();
    let schedule = Schedule::new(demand);
    let mut blocks = Blocks::empty(elements.starts(), true, work.ranks);
    let (tasks, counts) = schedule.sort(work.ranks);
    blocks.pairs = counts;
    if blocks.pairs.skipped_black > 0 {
        schedule.open_rows().into_iter().for_each(|row| blocks.leave_open(row));
    }
    let goals = schedule.goals(&tasks);
    let sources = schedule.share(&tasks, &goals);
    let mut integrated = schedule.integrate(&tasks, &goals, &sources, kept.as_deref(), blocks.held(), work);
    let scales = Scales::new(list.len(), &tasks, &sources, &integrated);
    let is_left = |task: &Task, block: &BlockReport| {
        block.untried || (scales.relative(task, block) > accuracy.eps && schedule.is_left(task))
    };
    integrated.deliver(&tasks, &sources, &is_left, blocks.held());
    let mut left = Vec::new();
    for (task, source) in tasks.iter().zip(&sources) {
        check_interrupt();
        let place = source.place();
        let IntegratedReport { block, .. } = integrated.report(place);
        let error = scales.relative(task, block);
        if is_left(task, block) {
            debug_assert!(matches!(source, Source::Own(_)), "only flat pairs that nothing hides are copies");
            let values = (!block.untried).then(|| integrated.values(place).to_vec());
            let by_rules = values.map(|values| BlockByRules { values, error: block.error });
            let (row, column) = (task.row as usize, task.column as usize);
            left.push(UnreachedPair { row, column, by_rules, partly_hidden: block.partly_hidden });
            blocks.pairs.take(block);
            blocks.pairs.unresolved -= usize::from(block.unresolved);
            blocks.take_costs(block);
            continue;
        }
        let asked = if block.partly_hidden { accuracy.shadow_eps } else { 0.0 }.max(accuracy.eps);
        let pair = [task.row as usize, task.column as usize];
        blocks.record_error(WorstError { pair, error, asked, by_rays: false });
        schedule.store(&mut blocks, task, source, &tasks, &integrated);
    }
    let is_left: HashSet<[usize; 2]> = left.iter().map(|pair| [pair.row, pair.column]).collect();
    let is_stored = |task: &Task| !is_left.contains(&[task.row as usize, task.column as usize]);
    blocks.reciprocity = schedule.reciprocity(&tasks, &is_stored, &goals, &sources, &integrated);
    if let Some(kept) = kept {
        let asked =
            tasks.iter().zip(&goals).zip(&sources).filter(|(_, source)| matches!(source, Source::Own(_)));
        let requests = asked.map(|((task, goal), _)| goal.request(task, visibility));
        let me = integrated.ranks.number();
        let own = integrated
            .blocks
            .into_iter()
            .zip(integrated.makers)
            .map(|(block, maker)| block.filter(|_| maker == me));
        let integrated = requests.zip(own).filter_map(|(request, block)| Some((request, block?)));
        kept.replace(integrated.collect(), work.ranks);
    }
    (blocks, left)
}

/// The scales of errors: the largest entries of the rows.
struct Scales {
    rows: Vec<f64>,
}

impl Scales {
    fn new(elements: usize, tasks: &[Task], sources: &[Source], integrated: &Integrated) -> Self {
        let mut rows = vec![0.0f64; elements];
        for (task, source) in tasks.iter().zip(sources) {
            let most = integrated.report(source.place()).block.largest;
            for element in [task.row, task.column] {
                rows[element as usize] = rows[element as usize].max(most);
            }
        }
        Self { rows }
    }

    /// The error of the block of a task, relative to the largest of: its largest entry, a hundredth of its
    /// row's, and 1e-8.
    fn relative(&self, task: &Task, block: &BlockReport) -> f64 {
        let row = self.rows[task.row as usize].min(self.rows[task.column as usize]);
        block.error / block.largest.max(ROW_SHARE * row).max(SMALLEST_ENTRY)
    }
}

impl Schedule<'_> {
    /// Sorts all pairs and counts those that need no block.
    fn sort(&self, ranks: &Ranks) -> (Vec<Task>, PairCounts) {
        let lengths: Vec<f64> = (1..=self.list.len()).rev().map(|length| length as f64).collect();
        let rows: Vec<(Vec<Task>, PairCounts)> =
            ranks.map(PartName::SortedPairs, &lengths, |row| self.sort_row(row));
        let mut tasks = Vec::with_capacity(rows.iter().map(|(row, _)| row.len()).sum());
        let mut pairs = PairCounts::default();
        for (row, counts) in rows {
            tasks.extend(row);
            pairs.total += counts.total;
            pairs.skipped_behind += counts.skipped_behind;
            pairs.skipped_coplanar += counts.skipped_coplanar;
            pairs.skipped_hidden += counts.skipped_hidden;
            pairs.skipped_black += counts.skipped_black;
        }
        (tasks, pairs)
    }

    /// The elements some of whose pairs are not wanted.
    fn open_rows(&self) -> Vec<usize> {
        let all = 0..self.list.len();
        let is_open = |i: &usize| {
            check_interrupt();
            all.clone().any(|j| !(self.wanted)(*i.min(&j), *i.max(&j)))
        };
        all.clone().filter(is_open).collect()
    }

    fn sort_row(&self, row: usize) -> (Vec<Task>, PairCounts) {
        let (mut tasks, mut counts) = (Vec::new(), PairCounts::default());
        for column in row..self.list.len() {
            let sorted = self.sorted(row, column);
            counts.total += usize::from(row != column || matches!(sorted, Sorted::Task(_) | Sorted::Black));
            match sorted {
                Sorted::Coplanar => counts.skipped_coplanar += usize::from(row != column),
                Sorted::Behind => counts.skipped_behind += 1,
                Sorted::Hidden => counts.skipped_hidden += 1,
                Sorted::Black => counts.skipped_black += 1,
                Sorted::Task(task) => tasks.push(task),
            }
        }
        (tasks, counts)
    }

    fn sorted(&self, row: usize, column: usize) -> Sorted {
        check_interrupt();
        if !(self.wanted)(row, column) {
            return Sorted::Black;
        }
        let (receiver, emitter) = (&self.list[row], &self.list[column]);
        if let Some(skipped) = self.planes_exchange_nothing(row, column) {
            return skipped;
        }
        if receiver.contact != emitter.contact {
            return Sorted::Hidden;
        }
        if receiver.contact.is_some() {
            return Sorted::Task(Task::of_contact(row, column));
        }
        let surfaces = [receiver.surface, emitter.surface];
        let blockers = self.visibility.candidates(&receiver.hull, &emitter.hull, surfaces);
        let estimate = if self.is_estimated { self.estimate(row, column) } else { 0.0 };
        let task = |entries, hash, blockers| {
            let own = self.visibility.hiding_themselves(surfaces, [&receiver.hull, &emitter.hull]);
            Sorted::Task(Task {
                row: row as u32,
                column: column as u32,
                entries,
                estimate,
                hash,
                blockers,
                own,
            })
        };
        if row == column {
            return task([0.0, f64::INFINITY], None, blockers);
        }
        if self.visibility.hidden(&blockers, &receiver.hull, &emitter.hull) {
            return Sorted::Hidden;
        }
        let [mut least, most] = self.bounds[row].entries(&self.bounds[column]);
        if receiver.plane.is_none() || emitter.plane.is_none() {
            least = BELOW_ESTIMATE * estimate;
        }
        if !blockers.is_empty() {
            return task([VISIBLE_SHARE * least, most], None, blockers);
        }
        task([least, most], self.pose_of(row, column).map(|pose| pose.hash()), blockers)
    }

    /// Coarse estimate of the first entry of the block of two elements, without blockers.
    fn estimate(&self, row: usize, column: usize) -> f64 {
        let [first, other] = if self.comes_later(row, column) { [column, row] } else { [row, column] };
        self.estimates[first].entry(&self.estimates[other])
    }

    /// Whether the first of two elements is the inner one ([`crate::schedule::order`]).
    fn comes_later(&self, first: usize, other: usize) -> bool {
        self.precedence[first].order(&self.precedence[other]).is_gt()
    }

    /// Why the planes of the two elements leave nothing to exchange, if they do.
    fn planes_exchange_nothing(&self, row: usize, column: usize) -> Option<Sorted> {
        match planes::of(&self.list[row], &self.list[column]) {
            Planes::Exchanging => None,
            Planes::Behind => Some(Sorted::Behind),
            Planes::Coplanar => Some(Sorted::Coplanar),
        }
    }

    fn pose_of(&self, row: usize, column: usize) -> Option<Pose> {
        Pose::of(self.panels[row].as_ref()?, self.panels[column].as_ref()?)
    }

    fn pose(&self, task: &Task) -> Option<Pose> {
        self.pose_of(task.row as usize, task.column as usize)
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
        task.blockers.is_empty() || self.visibility.are_planar(&task.blockers)
    }

    /// Stores the block of `task` and adds its cost.
    fn store(
        &self,
        blocks: &mut Blocks,
        task: &Task,
        source: &Source,
        tasks: &[Task],
        integrated: &Integrated,
    ) {
        let place = source.place();
        let IntegratedReport { block, remainder } = integrated.report(place);
        blocks.pairs.take(block);
        let (row, column) = (task.row as usize, task.column as usize);
        if *remainder > 0.0 {
            blocks.remainders.push(Remainder { places: [row, column], bound: *remainder });
        }
        match source {
            Source::Own(_) => blocks.take_costs(block),
            Source::Copy { .. } => {
                blocks.pairs.repeated += 1;
                blocks.samples += block.samples;
            }
        }
        match source {
            _ if block.largest == 0.0 => {}
            _ if !blocks.holds(row, column) => blocks.pass(row, column),
            Source::Own(_) => blocks.push(row, column, integrated.values(place)),
            Source::Copy { first, .. } => {
                let values = self.copied(task, &tasks[*first], integrated.values(place));
                blocks.push(row, column, &values);
            }
        }
    }

    /// The block of `task`, from the `values` of the congruent task `first`.
    fn copied<'b>(&self, task: &Task, first: &Task, values: &'b [f64]) -> Cow<'b, [f64]> {
        // A single constant has neither sign nor order.
        if values.len() == 1 {
            return Cow::Borrowed(values);
        }
        let [pose, other] = [task, first].map(|task| self.pose(task).expect("it was hashed"));
        Cow::Owned(pose.block_from(&other, values))
    }

    /// Finds tasks that are congruent to an earlier one and need the same accuracy.
    fn share(&self, tasks: &[Task], goals: &[Goal]) -> Vec<Source> {
        let mut first: HashMap<(u64, u64), usize> = HashMap::new();
        let candidates: Vec<Option<usize>> = tasks
            .iter()
            .zip(goals)
            .enumerate()
            .map(|(index, (task, goal))| {
                let found = *first.entry((task.hash?, goal.accuracy.eps.to_bits())).or_insert(index);
                (found != index).then_some(found)
            })
            .collect();
        let confirmed: Vec<Option<usize>> = (0..tasks.len())
            .into_par_iter()
            .map(|index| {
                check_interrupt();
                let first = candidates[index]?;
                self.pose(&tasks[index])?.equals(&self.pose(&tasks[first])?).then_some(first)
            })
            .collect();
        let mut places = vec![0; tasks.len()];
        let mut own = 0;
        let mut source = |(index, copied): (usize, Option<usize>)| {
            if let Some(first) = copied {
                return Source::Copy { first, place: places[first] };
            }
            places[index] = own;
            own += 1;
            Source::Own(places[index])
        };
        confirmed.into_iter().enumerate().map(&mut source).collect()
    }

    /// Integrates the tasks that are not copies, as far as `kept` does not hold their blocks; each rank
    /// some of them.
    ///
    /// Where blocks are kept, the rank that holds the row of a block integrates it in every scene: it has the
    /// block of the scene before.
    fn integrate(
        &self,
        tasks: &[Task],
        goals: &[Goal],
        sources: &[Source],
        kept: Option<&KeptBlocks>,
        held: &HeldRows,
        work: &Work<'_>,
    ) -> Integrated {
        let own: Vec<usize> =
            (0..tasks.len()).filter(|index| matches!(sources[*index], Source::Own(_))).collect();
        let (done, total) = (AtomicUsize::new(0), own.len());
        let ranks = work.ranks;
        let block = |place: usize| {
            let (task, goal) = (&tasks[own[place]], goals[own[place]]);
            let known = kept.and_then(|kept| self.kept_block(task, goal, kept));
            let block = known.unwrap_or_else(|| {
                let block = self.block(task, goal);
                ranks.count_work(block.samples, block.rays);
                Arc::new(IntegratedBlock::of(block))
            });
            // Others do about as much in the same time.
            let done = ranks.count() * (done.fetch_add(1, Ordering::Relaxed) + 1);
            work.report_done(Stage::Blocks, done.min(total), total);
            block
        };
        if kept.is_some() {
            let makers: Vec<usize> = own.iter().map(|index| held.rank(tasks[*index].row as usize)).collect();
            return Integrated::made_by(ranks.clone(), &makers, block);
        }
        Integrated::made(ranks.clone(), &self.items(tasks, sources), block)
    }

    /// The work of the tasks that are not copies: classes and prices.
    fn items(&self, tasks: &[Task], sources: &[Source]) -> Vec<WorkItem> {
        let own = tasks.iter().zip(sources).filter(|(_, source)| matches!(source, Source::Own(_)));
        own.map(|(task, _)| self.item(task)).collect()
    }

    /// The work of a task: its class and price.
    fn item(&self, task: &Task) -> WorkItem {
        let ends @ [row, column] = [task.row, task.column].map(|element| element as usize);
        let are_flat = ends.iter().all(|element| self.list[*element].plane.is_some());
        let is_near = row == column || self.bounds[row].is_near(&self.bounds[column]);
        let bits = [are_flat, is_near, row == column, task.own.is_empty()];
        let bits = bits.iter().fold(0, |bits, bit| 2 * bits + u64::from(*bit));
        let class = 16 * task.blockers.len() as u64 + bits;
        WorkItem { class, price: price::of_blockers(are_flat, &task.blockers, self.visibility) }
    }

    fn block(&self, task: &Task, goal: Goal) -> Block {
        self.block_from(self.is_turned(task), task, goal)
    }

    /// The block of a task; where it is `turned`, the outer integral is over the emitter.
    fn block_from(&self, turned: bool, task: &Task, goal: Goal) -> Block {
        let places @ [row, column] = [task.row, task.column].map(|index| index as usize);
        if turned {
            let rows = self.list[column].basis.len();
            return self.block_of([column, row], task, goal).turned(rows);
        }
        self.block_of(places, task, goal)
    }

    /// Integrates a sample of the pairs that were stored, one in a hundred, with the roles of the elements
    /// exchanged; none above mean cost.
    fn reciprocity(
        &self,
        tasks: &[Task],
        is_stored: &dyn Fn(&Task) -> bool,
        goals: &[Goal],
        sources: &[Source],
        integrated: &Integrated,
    ) -> Reciprocity {
        let own = |(index, source): (usize, &Source)| match source {
            Source::Own(place) if tasks[index].row != tasks[index].column && is_stored(&tasks[index]) => {
                Some((index, *place))
            }
            _ => None,
        };
        let pairs: Vec<(usize, usize)> = sources.iter().enumerate().filter_map(own).collect();
        let cost =
            |place: usize| integrated.report(place).block.samples + integrated.report(place).block.rays;
        let mean = pairs.iter().map(|(_, place)| cost(*place)).sum::<u64>() / pairs.len().max(1) as u64;
        let step = (pairs.len() / (pairs.len() / SAMPLED_SHARE).max(FEWEST_SAMPLED)).max(1);
        let sample: Vec<(usize, usize)> =
            pairs.into_iter().filter(|(_, place)| cost(*place) <= mean).step_by(step).collect();
        let makers: Vec<usize> = sample.iter().map(|(_, place)| integrated.makers[*place]).collect();
        let differences: Vec<Option<f64>> =
            integrated.ranks.map_by(PartName::ExchangedBlocks, &makers, |number| {
                let (index, place) = sample[number];
                let task = &tasks[index];
                let [a, b] = [task.row, task.column].map(|element| self.list[element as usize].area);
                let block = integrated.block(place);
                let again = *block.exchanged.get_or_init(|| {
                    let again = self.block_from(!self.is_turned(task), task, goals[index]);
                    (!again.untried).then(|| again.values[0])
                });
                again.map(|again| (again - block.block.values[0]).abs() * (a * b).sqrt() / a.min(b))
            });
        let mut reciprocity = Reciprocity::default();
        differences.into_iter().flatten().for_each(|difference| reciprocity.take(difference));
        reciprocity
    }

    /// Whether the outer integral of a task is over its emitter ([`crate::schedule::order`]). Flat elements
    /// without blockers give the same block either way.
    fn is_turned(&self, task: &Task) -> bool {
        let [row, column] = [task.row, task.column].map(|index| index as usize);
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
        let is_flat = pair.iter().all(|element| element.plane.is_some());
        let block = |blockers: &[usize]| match is_flat {
            true => flat::block(receiver, emitter, blockers, self.visibility, goal.tolerance()),
            false => self.curved_block(places, task, blockers, goal),
        };
        match goal.outlined {
            Some(limit) => occluded_block(pair, &task.blockers, self.visibility, limit, || block(&[])),
            None if is_flat => self.hidden_block(places, task, goal).unwrap_or_else(|| {
                if self.unreached == Unreached::Left && !self.casts_flat_shadows(task) {
                    return Block::untried(
                        pair.map(|own| own.basis.len()).iter().product(),
                        PairKind::Separated,
                        0,
                    );
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
            let parts = [&self.parts[row][..], &self.parts[column][..]];
            let surfaces = [receiver.surface, emitter.surface];
            let most = if is_told { enough } else { MOST_OWN_RAYS };
            let met = ProbingRays::between(parts, surfaces, asked, &task.own, self.visibility, most);
            rays = met.rays;
            match (is_told && rays as f64 >= enough, met.hidden) {
                (true, Hidden::All) => {
                    return Block::hidden(receiver.basis.len() * emitter.basis.len(), rays);
                }
                (true, Hidden::None) => blockers = Cow::Borrowed(&[]),
                _ => blockers.to_mut().extend(met.own),
            }
        }
        // What a ball hides of a surface from itself is not known well enough either.
        let is_ball = row != column && self.visibility.only_ball(&blockers).is_some();
        let is_near = self.bounds[row].is_near(&self.bounds[column]);
        if self.unreached == Unreached::Left && is_near && !blockers.is_empty() && !is_ball {
            let kind = if row == column { PairKind::Same } else { PairKind::Separated };
            return Block::untried(receiver.basis.len() * emitter.basis.len(), kind, rays);
        }
        let tolerance = goal.tolerance_of_curved(&blockers);
        let mut block = if row == column {
            curved::self_block(receiver, &blockers, self.visibility, tolerance)
        } else {
            curved::block(receiver, emitter, &blockers, self.visibility, tolerance)
        };
        block.rays += rays;
        block
    }

    /// The zero block of two flat elements if all probing rays are hidden. None if one passes, or if there
    /// are too few rays to bound what is visible.
    fn hidden_block(&self, [receiver, emitter]: [usize; 2], task: &Task, goal: Goal) -> Option<Block> {
        if task.blockers.is_empty() {
            return None;
        }
        let sees = |x, y| self.visibility.free(&task.blockers, x, y);
        let rays = self.estimates[receiver].hidden_rays(&self.estimates[emitter], &sees)?;
        let size = self.list[receiver].basis.len() * self.list[emitter].basis.len();
        let is_told = rays >= FEWEST_RAYS && RULE_OF_THREE * task.estimate <= goal.unseen * rays as f64;
        is_told.then(|| Block::hidden(size, rays))
    }
}
