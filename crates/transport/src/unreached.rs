//! Blocks that no rule reaches, by rays from both sides.
//!
//! Curved surfaces that touch, come very near, or hide each other or themselves leave pairs whose rules do
//! not converge, or do not know their error. Cosine-distributed rays know no singular pair
//! ([`crate::sampled`]). [`BATCHES`] independent sequences of equal length estimate each of these blocks;
//! with the standard deviation s of the batches
//!
//! ```text
//! G = mean ,     error = DEVIATIONS · max_kl s_kl / √BATCHES + 1 / (D √(A_i A_j)) ,     D = n_i/A_i +
//! n_j/A_j ,
//! ```
//!
//! the last term for what fewer than one ray meets. View factors of surfaces are sums over their elements,
//! whose errors partly cancel: there s is that of the sums ([`wholes`]). Rounds of twice as many rays as the
//! one before follow until the error is small enough for the view factors of either element, relative to the
//! largest of its row, or until [`most_rays`]. Where the largest error is to stay above what is asked, pairs
//! whose errors are below half of it get no more ([`AMONG_WORST`]), and ends that would tell little send none
//! ([`LARGER`]); others get no more rays for that. The rays that tell when to stop are those that tell the
//! error, so that it is told a little too small.
//!
//! A value by rules is kept where rays agree with it and its own error, times [`MISSED_BY_RULES`], is smaller
//! than theirs.

mod ray_block;
mod wholes;

use std::collections::{HashMap, HashSet};

use radiosity_elements::Element;
use radiosity_kernel::blocks::FirstEntry;
use radiosity_kernel::{Accuracy, Blocks, PlacedBlock, WorstError};
use radiosity_work::{Stage, Work};

use crate::kept_blocks::KeptBlocks;
use crate::sampled::{Fixed, SampledTransport};
use crate::schedule::order::Precedence;
use crate::schedule::{BlockByRules, Demand, UnreachedPair, asked};
use crate::tolerances::{AGREED_BY_RAYS, BATCHES, DEVIATIONS, MISSED_BY_RULES};
use ray_block::RayBlock;
use wholes::Wholes;

/// Rays of each element and batch in the first round: 16 384 of an element in all, which tell a factor of ½
/// to a percent. With fewer the errors of batches tell little.
const FIRST: u64 = 1 << 11;

/// Rays in all, at an accuracy of 1e-3, and by which power of the accuracy they grow, down to [`FINEST`].
/// Chosen: one to two seconds on two cores, and ten to twenty.
const MOST: f64 = 8e6;
const MOST_POWER: f64 = 0.35;
const MOST_AT: f64 = 1e-3;

/// Elements that share these rays, 250 000 for each; more of them send more in proportion.
const FEW: f64 = 32.0;
/// The accuracy below which no more rays are sent: five times as many as at 1e-3.
pub const FINEST: f64 = 1e-5;

/// Relative error that no more rays are sent for, whatever is asked. Chosen: pairs get there whose row sums
/// are known.
const ENOUGH: f64 = 1e-6;

/// Relative error that most pairs get to by all rays they may have: 5e-5 to 2e-4 on spheres, cylinders and
/// cones.
const REACHED: f64 = 1e-4;

/// Errors by this much smaller than the largest one will be in the end, by the law of √N, are enough where that
/// one stays above what is asked: it is what is told. Chosen: the sum of both squares is a quarter more.
const AMONG_WORST: f64 = 0.5;

/// Ratio of areas from which the larger end of a pair sends no rays for it after the first round: they would be
/// a sixteenth of what counts, and change the error by 3 %.
const LARGER: f64 = 16.0;

/// Relative error of rays that is enough to check a value by rules: those that failed are off by more. With a
/// smaller value the check takes as long as the rays would take by themselves.
const CHECKED: f64 = 1e-3;

/// Adds the blocks of a demand that are `left` to `blocks`, and tells their error there; rays that `kept`
/// holds are not traced.
pub(crate) fn add(
    blocks: &mut Blocks,
    left: &[UnreachedPair],
    demand: Demand,
    mut kept: Option<&mut KeptBlocks>,
    work: &Work<'_>,
) {
    let Demand { elements, accuracy, whole, .. } = demand;
    let mut batches = batches(left, demand, kept.as_deref_mut(), work);
    let sums = blocks.apply(&elements.constant());
    let error = accuracy.eps.max(accuracy.shadow_eps).max(blocks.statistics.accuracy_reached);
    let pairs = LeftPairs {
        list: elements.list(),
        left,
        wholes: Wholes::new(elements.list(), whole),
        firsts: blocks.first_entries(),
        fixed: Fixed { sums: &sums, error, blocks },
        accuracy,
    };
    let (found, sent) = pairs.found(&mut batches, work);
    if let Some(kept) = kept {
        let rays = batches.into_iter().map(SampledTransport::into_kept).enumerate();
        rays.filter_map(|(batch, rays)| Some((batch, rays?)))
            .for_each(|(batch, rays)| kept.put_rays(batch, rays, work.ranks));
    }
    blocks.statistics.rays += sent;
    blocks.statistics.pairs.by_rays += left.len();
    for (RayBlock { row, column, values, relative, share, .. }, pair) in found.into_iter().zip(left) {
        blocks.push(row, column, &values);
        let (pair, asked) = ([row, column], asked(pair.partly_hidden, accuracy));
        blocks.statistics.record_error(WorstError { pair, error: relative, asked, by_rays: true });
        blocks.statistics.take_exchange(pair, elements.list().len(), share, 0.0);
    }
}

/// The batches of rays for these pairs, before any is sent.
fn batches<'a>(
    left: &[UnreachedPair],
    Demand { elements, visibility, .. }: Demand<'a>,
    mut kept: Option<&mut KeptBlocks>,
    work: &Work<'a>,
) -> Vec<SampledTransport<'a>> {
    let pairs: HashSet<(u32, u32)> = left.iter().map(|pair| (pair.row as u32, pair.column as u32)).collect();
    let places = places(elements.list());
    let batch = |batch: usize| {
        let numbers: Vec<u64> = places.iter().map(|place| (batch * places.len() + place) as u64).collect();
        let rays = SampledTransport::of_pairs(elements, visibility, pairs.clone(), &numbers, work.ranks);
        rays.with_kept(kept.as_mut().and_then(|kept| kept.take_rays(batch, BATCHES, numbers, work.ranks)))
    };
    (0..BATCHES).map(batch).collect()
}

/// The place of each element in an order that does not depend on how the scene lists its surfaces.
fn places(list: &[Element]) -> Vec<usize> {
    let keys: Vec<Precedence> = list.iter().map(Precedence::of).collect();
    let mut order: Vec<usize> = (0..list.len()).collect();
    order.sort_by(|a, b| keys[*a].order(&keys[*b]));
    let mut places = vec![0; list.len()];
    order.into_iter().enumerate().for_each(|(rank, element)| places[element] = rank);
    places
}

/// Most rays for an accuracy, from so many elements.
fn most_rays(eps: f64, elements: usize) -> u64 {
    let share = (elements as f64 / FEW).max(1.0);
    (MOST * share * (MOST_AT / eps.max(FINEST)).powf(MOST_POWER)) as u64
}

/// The pairs that the rules leave to rays, and what is known of the blocks of all others.
struct LeftPairs<'a> {
    list: &'a [Element],
    left: &'a [UnreachedPair],
    wholes: Wholes,
    /// First entries of the other blocks.
    firsts: Vec<FirstEntry>,
    fixed: Fixed<'a>,
    accuracy: Accuracy,
}

/// Sums of one pair over the batches.
struct BatchSums {
    /// Sums of the entries, and of their squares.
    values: Vec<f64>,
    squares: Vec<f64>,
    /// The first entry by each batch.
    firsts: [f64; BATCHES],
}

impl LeftPairs<'_> {
    /// Sends rays until all blocks are accurate enough, or as many as they may take; returns the blocks, and
    /// the number of rays.
    fn found(&self, batches: &mut [SampledTransport], work: &Work<'_>) -> (Vec<RayBlock>, u64) {
        let ends = |pairs: &[&UnreachedPair]| -> HashSet<usize> {
            pairs.iter().flat_map(|pair| [pair.row, pair.column]).collect()
        };
        let mut open: Vec<&UnreachedPair> = self.left.iter().collect();
        let (mut sharing, most) = (ends(&open).len() as u64, most_rays(self.accuracy.eps, ends(&open).len()));
        let (mut sent, mut spent, mut rays) = (0, 0, FIRST);
        let mut senders = ends(&open);
        loop {
            for batch in batches.iter_mut() {
                // Those that sat out rounds go on from the one they left off at.
                let own = batch.sent().iter().map(|sent| rays.min(sent + FIRST));
                let of_senders = |(index, own)| if senders.contains(&index) { own } else { 0 };
                let now: Vec<u64> = own.enumerate().map(of_senders).collect();
                batch.send(&now, &mut |_| true);
                sent += now.iter().sum::<u64>();
                spent += sharing * rays;
                let done = (self.left.len() as u64 * spent / most.max(spent)) as usize;
                work.report_done(Stage::Blocks, done, self.left.len());
            }
            let found = self.estimated(batches);
            let missing = self.left.iter().zip(&found).filter(|(pair, found)| self.is_open(pair, found));
            let missing: Vec<(&UnreachedPair, f64)> =
                missing.map(|(pair, found)| (pair, found.relative)).collect();
            let within = AMONG_WORST * (spent as f64 / most as f64).min(1.0).sqrt();
            let worst = missing.iter().map(|(_, relative)| *relative).fold(0.0, f64::max);
            let worse = missing.iter().filter(|(_, relative)| *relative > within * worst);
            open = worse.map(|(pair, _)| *pair).collect();
            let missing: Vec<&UnreachedPair> = missing.into_iter().map(|(pair, _)| pair).collect();
            (sharing, senders) = (ends(&missing).len() as u64, self.senders(&open));
            // Twice those of this round, as far as there are any left.
            let next = (2 * rays).min(most.saturating_sub(spent) / (BATCHES as u64 * sharing).max(1));
            if open.is_empty() || next < rays / 2 {
                return (found, sent);
            }
            rays = next;
        }
    }

    /// The elements whose rays tell most of these pairs: both ends, or the smaller one alone. A ray counts by
    /// one over the area that it leaves.
    fn senders(&self, pairs: &[&UnreachedPair]) -> HashSet<usize> {
        let telling = |pair: &&UnreachedPair| {
            let ends = [pair.row, pair.column];
            let least = ends.map(|end| self.list[end].area).into_iter().fold(f64::INFINITY, f64::min);
            ends.into_iter().filter(move |end| self.list[*end].area < LARGER * least)
        };
        pairs.iter().flat_map(telling).collect()
    }

    /// Whether more rays are wanted for a pair. They cannot better a value by rules that is as good as they
    /// become.
    fn is_open(&self, pair: &UnreachedPair, found: &RayBlock) -> bool {
        found.relative > asked(pair.partly_hidden, self.accuracy).max(ENOUGH)
            && (!found.is_by_rules || found.relative > REACHED)
    }

    /// The block of each pair as the batches estimate it, or as the rules do where rays agree.
    fn estimated(&self, batches: &[SampledTransport]) -> Vec<RayBlock> {
        let mut sums = self.sums(batches);
        let density = |element: usize| {
            batches.iter().map(|batch| batch.sent()[element] as f64).sum::<f64>() / self.list[element].area
        };
        let estimate = |(pair, sums): (&UnreachedPair, &BatchSums)| {
            let unit = (self.list[pair.row].area * self.list[pair.column].area).sqrt();
            sums.estimate(pair, 1.0 / ((density(pair.row) + density(pair.column)) * unit))
        };
        let mut found: Vec<RayBlock> = self.left.iter().zip(&sums).map(estimate).collect();
        let rows = self.wholes.largest_factors(self.list, &self.firsts, &found);
        for ((found, pair), sums) in found.iter_mut().zip(self.left).zip(&mut sums) {
            if let Some(BlockByRules { values, error }) = &pair.by_rules
                && MISSED_BY_RULES * error < found.error
                && self.wholes.relative(self.list, &rows, found) <= CHECKED
                && agree(values, &found.values, found.error)
            {
                found.values.clone_from(values);
                (found.error, found.one, found.is_by_rules) =
                    (MISSED_BY_RULES * error, MISSED_BY_RULES * error, true);
                sums.firsts = [values[0]; BATCHES];
            }
        }
        let firsts: Vec<[f64; BATCHES]> = sums.iter().map(|sums| sums.firsts).collect();
        self.wholes.judge(self.list, &rows, &mut found, &firsts);
        found
    }

    /// The sums of each pair over the batches.
    fn sums(&self, batches: &[SampledTransport]) -> Vec<BatchSums> {
        let places: HashMap<(usize, usize), usize> =
            self.left.iter().enumerate().map(|(place, pair)| ((pair.row, pair.column), place)).collect();
        let nothing = |pair: &UnreachedPair| {
            let size = self.list[pair.row].basis.len() * self.list[pair.column].basis.len();
            BatchSums { values: vec![0.0; size], squares: vec![0.0; size], firsts: [0.0; BATCHES] }
        };
        let mut all: Vec<BatchSums> = self.left.iter().map(nothing).collect();
        for (number, batch) in batches.iter().enumerate() {
            for PlacedBlock { row, column, values } in batch.beside(&self.fixed).iter() {
                let own = &mut all[places[&(row, column)]];
                own.firsts[number] = values[0];
                for ((sum, square), value) in own.values.iter_mut().zip(&mut own.squares).zip(values.iter()) {
                    *sum += value;
                    *square += value * value;
                }
            }
        }
        all
    }
}

impl BatchSums {
    /// The block of a pair by these sums, to an entry of which one ray adds `one`.
    fn estimate(&self, &UnreachedPair { row, column, .. }: &UnreachedPair, one: f64) -> RayBlock {
        let n = BATCHES as f64;
        let values: Vec<f64> = self.values.iter().map(|sum| sum / n).collect();
        let deviation =
            |(mean, square): (&f64, &f64)| ((square / n - mean * mean).max(0.0) / (n - 1.0)).sqrt();
        let largest = values.iter().zip(&self.squares).map(deviation).fold(0.0, f64::max);
        let error = DEVIATIONS * largest + one;
        RayBlock { row, column, values, one, error, is_by_rules: false, relative: 0.0, share: 0.0 }
    }
}

/// Whether values by rules and by rays are as near as they should be: one in two thousand is not, by chance
/// (Student).
fn agree(a: &[f64], b: &[f64], error: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= AGREED_BY_RAYS * error)
}
