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
//! largest of its row, or until [`most_rays`]. The rays that tell when to stop are those that tell the error,
//! so that it is told a little too small.
//!
//! A value by rules is kept where rays agree with it and its own error, times [`MISSED_BY_RULES`], is smaller
//! than theirs.

mod ray_block;
mod wholes;

use std::collections::{HashMap, HashSet};

use radiosity_elements::Element;
use radiosity_kernel::{Blocks, blocks::FirstEntry};
use radiosity_kernel::{PlacedBlock, WorstError};
use radiosity_work::{Stage, Work};

use crate::kept_blocks::KeptBlocks;
use crate::sampled::{Fixed, SampledTransport};
use crate::schedule::order::Precedence;
use crate::schedule::{BlockByRules, Demand, UnreachedPair};
use crate::tolerances::{AGREED_BY_RAYS, BATCHES, DEVIATIONS, MISSED_BY_RULES};
use ray_block::RayBlock;
pub(crate) use wholes::Whole;
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

/// Relative error of rays that is enough to check a value by rules: those that failed are off by more. With a
/// smaller value the check takes as long as the rays would take by themselves.
const CHECKED: f64 = 1e-3;

/// Adds the blocks of a demand that are `left` to `blocks`, and tells their error there; rays that `kept`
/// holds are not traced.
pub(crate) fn add(
    blocks: &mut Blocks,
    left: &[UnreachedPair],
    demand: Demand,
    whole: Whole,
    mut kept: Option<&mut KeptBlocks>,
    work: &Work<'_>,
) {
    let Demand { elements, visibility, accuracy, .. } = demand;
    let wholes = Wholes::new(elements.list(), whole);
    let pairs: HashSet<(u32, u32)> = left.iter().map(|pair| (pair.row as u32, pair.column as u32)).collect();
    let places = places(elements.list());
    let mut batch = |batch: usize| {
        let numbers: Vec<u64> = places.iter().map(|place| (batch * places.len() + place) as u64).collect();
        let rays = SampledTransport::of_pairs(elements, visibility, pairs.clone(), &numbers, work.ranks);
        rays.with_kept(kept.as_mut().and_then(|kept| kept.take_rays(batch, BATCHES, numbers, work.ranks)))
    };
    let mut batches: Vec<SampledTransport> = (0..BATCHES).map(&mut batch).collect();
    let touched: HashSet<usize> = left.iter().flat_map(|pair| [pair.row, pair.column]).collect();
    let most = most_rays(accuracy.eps, touched.len());
    let goal =
        |pair: &UnreachedPair| if pair.partly_hidden { accuracy.shadow_eps } else { 0.0 }.max(accuracy.eps);
    let error = accuracy.eps.max(accuracy.shadow_eps).max(blocks.accuracy_reached);
    let sums = blocks.apply(&elements.constant());
    let firsts = blocks.first_entries();
    let (mut sent, mut rays) = (0, FIRST);
    let mut open: Vec<&UnreachedPair> = left.iter().collect();
    let found = loop {
        let senders: HashSet<usize> = open.iter().flat_map(|pair| [pair.row, pair.column]).collect();
        let now: Vec<u64> =
            (0..elements.list().len()).map(|index| if senders.contains(&index) { rays } else { 0 }).collect();
        for batch in &mut batches {
            batch.send(&now, &mut |_| true);
            sent += senders.len() as u64 * rays;
            work.report_done(Stage::Blocks, (left.len() as u64 * sent / most.max(sent)) as usize, left.len());
        }
        let each = (BATCHES * senders.len()) as u64;
        let fixed = Fixed { sums: &sums, error, blocks };
        let found = judged(elements.list(), &wholes, &firsts, &fixed, left, &batches);
        // Rays cannot better a value by rules that is as good as they become.
        let may_fall = |found: &RayBlock| !found.is_by_rules || found.relative > REACHED;
        let is_open = |(pair, found): &(&UnreachedPair, &RayBlock)| {
            found.relative > goal(pair).max(ENOUGH) && may_fall(found)
        };
        let missing = left.iter().zip(&found).filter(is_open);
        open = missing.map(|(pair, _)| pair).collect();
        // Twice those of this round, as far as there are any left.
        let next = (2 * rays).min(most.saturating_sub(sent) / each);
        if open.is_empty() || next < rays / 2 {
            break found;
        }
        rays = next;
    };
    if let Some(kept) = kept {
        let rays = batches.into_iter().map(SampledTransport::into_kept).enumerate();
        rays.filter_map(|(batch, rays)| Some((batch, rays?)))
            .for_each(|(batch, rays)| kept.put_rays(batch, rays, work.ranks));
    }
    blocks.rays += sent;
    blocks.pairs.by_rays += left.len();
    for (RayBlock { row, column, values, relative, .. }, pair) in found.into_iter().zip(left) {
        blocks.push(row, column, &values);
        blocks.record_error(WorstError {
            pair: [row, column],
            error: relative,
            asked: goal(pair),
            by_rays: true,
        });
    }
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

/// The block of each pair as the batches estimate it, given the first entries of the other blocks.
fn judged(
    list: &[Element],
    wholes: &Wholes,
    others_firsts: &[FirstEntry],
    others: &Fixed,
    left: &[UnreachedPair],
    batches: &[SampledTransport],
) -> Vec<RayBlock> {
    let sizes = |pair: &UnreachedPair| list[pair.row].basis.len() * list[pair.column].basis.len();
    let places: HashMap<(usize, usize), usize> =
        left.iter().enumerate().map(|(place, pair)| ((pair.row, pair.column), place)).collect();
    let mut sums: Vec<[Vec<f64>; 2]> =
        left.iter().map(|pair| [vec![0.0; sizes(pair)], vec![0.0; sizes(pair)]]).collect();
    let mut firsts = vec![[0.0; BATCHES]; left.len()];
    for (number, batch) in batches.iter().enumerate() {
        for PlacedBlock { row, column, values } in batch.beside(others).iter() {
            let place = places[&(row, column)];
            let [sum, squares] = &mut sums[place];
            firsts[place][number] = values[0];
            for ((sum, square), value) in sum.iter_mut().zip(squares).zip(values.iter()) {
                *sum += value;
                *square += value * value;
            }
        }
    }
    let n = BATCHES as f64;
    let density = |element: usize| {
        batches.iter().map(|batch| batch.sent()[element] as f64).sum::<f64>() / list[element].area
    };
    let found = left.iter().zip(sums).map(|(pair, [sum, squares])| {
        let values: Vec<f64> = sum.iter().map(|sum| sum / n).collect();
        let deviation =
            |(mean, square): (&f64, &f64)| ((square / n - mean * mean).max(0.0) / (n - 1.0)).sqrt();
        let largest = values.iter().zip(&squares).map(deviation).fold(0.0, f64::max);
        let unit = (list[pair.row].area * list[pair.column].area).sqrt();
        let one = 1.0 / ((density(pair.row) + density(pair.column)) * unit);
        RayBlock {
            row: pair.row,
            column: pair.column,
            values,
            one,
            error: DEVIATIONS * largest + one,
            is_by_rules: false,
            relative: 0.0,
        }
    });
    let mut found: Vec<RayBlock> = found.collect();
    let rows = wholes.largest_factors(list, others_firsts, &found);
    for ((found, pair), firsts) in found.iter_mut().zip(left).zip(&mut firsts) {
        if let Some(BlockByRules { values, error }) = &pair.by_rules
            && MISSED_BY_RULES * error < found.error
            && wholes.relative(list, &rows, found) <= CHECKED
            && agree(values, &found.values, found.error)
        {
            found.values.clone_from(values);
            (found.error, found.one, found.is_by_rules) =
                (MISSED_BY_RULES * error, MISSED_BY_RULES * error, true);
            *firsts = [values[0]; BATCHES];
        }
    }
    wholes.judge(list, &rows, &mut found, &firsts);
    found
}

/// Whether values by rules and by rays are as near as they should be: one in two thousand is not, by chance
/// (Student).
fn agree(a: &[f64], b: &[f64], error: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= AGREED_BY_RAYS * error)
}
