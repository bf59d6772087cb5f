//! Blocks from rays: who sees whom is answered for all pairs of a row at once.
//!
//! Element i sends n_i rays, from points x spread evenly over its area A_i in cosine-distributed directions.
//! A ray that first meets the front of element j at y has the density (1/A_i) κ V, the shape of the
//! integrand, from either end. Combined with the rays from j by the balance heuristic,
//!
//! ```text
//! G_ij^kl ≈ Σ φ_k(x) φ_l(y) / (n_i/A_i + n_j/A_j)   over all rays i → j and j → i ,
//! ```
//!
//! without bias, symmetric, each ray used in both directions; backs absorb. Row sums are then made to agree
//! with the shares of rays that hit something, as far as these are known better ([`estimate`]). The rays of
//! even and of odd number are two estimates of their own: half of what they differ by is about the error of
//! their mean.
//!
//! Of pairs whose blocks are known but for what hides a part of them, only the rays that are stopped on the way
//! count ([`unhidden_pairs`]).
//!
//! Pairs on which many rays would land are carried by the exact rules, if that costs less ([`exact_pairs`]).
//!
//! What lies on another surface exchanges with it alone, exactly ([`radiosity_kernel::rules::covering`]), and
//! sends no rays.
//!
//! References: A. Keller, *Quasi-Monte Carlo radiosity*, EGWR 1996, 101-110; E. Veach, L. Guibas, SIGGRAPH
//! 1995, 419-428 (the balance heuristic); Ph. Bekaert, *Hierarchical and stochastic algorithms for
//! radiosity*, K. U. Leuven 1999.

mod sender;
mod hit;
mod tally;
mod element_sums;
mod exact_pairs;
mod unhidden_pairs;
mod rays;
mod closure;
mod estimate;
pub(crate) mod standing;

use std::collections::{BTreeMap, HashSet};

use radiosity_elements::{Element, Elements};
use radiosity_geom::Encounter;
use radiosity_kernel::Accuracy;
use radiosity_kernel::Blocks;
use radiosity_kernel::blocks::held_rows::HeldRows;
use radiosity_kernel::rules::covering;
use radiosity_visibility::Visibility;
use radiosity_work::Work;
use radiosity_work::interruption::check_interrupt_at;
use radiosity_work::ranks::{PartName, Ranks, shares};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::kept_blocks::{KeptBlocks, KeptHit, KeptRays};
use element_sums::{CountedRay, ElementSums};
pub(crate) use estimate::Fixed;
use estimate::{Counted, Counts, Estimate};
use exact_pairs::ExactPairs;
use hit::{Hit, hit};
pub use rays::Rays;
use sender::{Departure, Sender};
pub use standing::StandingRays;
use standing::{ElementRays, StandingRay, State};
use tally::{Sums, Tally};
use unhidden_pairs::UnhiddenPairs;

/// Relative error of exact pairs, as far as it matters here. Chosen: the default accuracy of their blocks.
const EXACT: f64 = 1e-3;

/// Rays whose hits are held at a time: some 30 MB.
const CHUNK: u64 = 1 << 19;

/// Rays that one task sends.
const TASK: u64 = 1 << 12;

/// Rays sent so far between elements, and what they met.
#[derive(Debug)]
pub struct SampledTransport<'a> {
    elements: &'a Elements,
    visibility: &'a Visibility,
    senders: Vec<Sender>,
    /// Rays sent by each element, those of the pilot round included.
    sent: Vec<u64>,
    /// Rays of each element in the pilot round.
    pilot: Vec<u64>,
    starts: Vec<usize>,
    counts: Counts,
    /// The ranks that send the rays.
    ranks: &'a Ranks,
    /// Elements whose pairs each rank counts; all of them where they are few.
    held: HeldRows,
    tally: Tally,
    exact_pairs: ExactPairs,
    /// The pairs that are carried exactly where rules reach their accuracy.
    worth: HashSet<(u32, u32)>,
    /// The pairs on which rays count, if not on all but the exact pairs.
    only: Option<HashSet<(u32, u32)>>,
    /// The pairs among these of which only what is hidden is counted.
    unhidden: UnhiddenPairs,
    /// Hits of these rays in the scene before, if those were kept.
    kept: Option<KeptRays>,
    /// The rays that count, where they stand from scene to scene.
    rays: Option<Vec<ElementRays>>,
}

/// Rays of one element, one after the other.
#[derive(Clone, Copy, Debug)]
struct RayTask {
    element: usize,
    first: u64,
    count: u64,
}

/// Sums over the rays of a task, and its hits, as far as a rank counts them.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct RaySums {
    sums: ElementSums,
    /// Hits of the rays that landed on pairs that the rank counts.
    hits: Vec<Hit>,
}

/// The rays of a task that this rank sent.
#[derive(Debug, Serialize, Deserialize)]
struct SentRays {
    sums: RaySums,
    /// Hit of each ray, where that is to be kept, and number of rays that were not traced for it.
    hits: Vec<KeptHit>,
    recalled: u64,
}

impl RaySums {
    /// These sums without the hits.
    fn without_hits(&self) -> Self {
        Self { sums: self.sums.clone(), hits: Vec::new() }
    }
}

impl<'a> SampledTransport<'a> {
    /// The transport between all elements whose rays these ranks send, before any is sent.
    pub fn new(elements: &'a Elements, visibility: &'a Visibility, ranks: &'a Ranks) -> Self {
        Self::numbered(elements, visibility, &|place| place as u64, ranks)
    }

    /// The transport of these pairs only, the element that comes first in front. The rays of element k are
    /// those of number `numbers[k]`.
    pub(crate) fn of_pairs(
        elements: &'a Elements,
        visibility: &'a Visibility,
        pairs: HashSet<(u32, u32)>,
        numbers: &[u64],
        ranks: &'a Ranks,
    ) -> Self {
        let starts = elements.starts();
        Self {
            unhidden: UnhiddenPairs::among(&pairs, elements.list()),
            only: Some(pairs),
            held: HeldRows::of(Ranks::alone(), &starts),
            ..Self::numbered(elements, visibility, &|element| numbers[element], ranks)
        }
    }

    /// The transport by rays that depend on the `number` of each element.
    fn numbered(
        elements: &'a Elements,
        visibility: &'a Visibility,
        number: &(dyn Fn(usize) -> u64 + Sync),
        ranks: &'a Ranks,
    ) -> Self {
        let list = elements.list();
        let senders = list.par_iter().enumerate().map(|(place, element)| Sender::new(element, number(place)));
        let starts = elements.starts();
        Self {
            elements,
            visibility,
            senders: senders.collect(),
            sent: vec![0; list.len()],
            pilot: vec![0; list.len()],
            ranks,
            held: HeldRows::of(ranks, &starts),
            starts,
            counts: Counts::new(list.len(), elements.coefficients()),
            tally: Tally::new(list.len()),
            exact_pairs: ExactPairs::default(),
            worth: HashSet::new(),
            only: None,
            unhidden: UnhiddenPairs::default(),
            kept: None,
            rays: None,
        }
    }

    /// The transport by these rays, to the bit; rays whose hits were `kept` are not traced.
    pub(crate) fn with_kept(self, kept: Option<KeptRays>) -> Self {
        Self { kept, ..self }
    }

    /// The hits of its rays after they were sent.
    pub(crate) fn into_kept(self) -> Option<KeptRays> {
        self.kept
    }

    /// The transport between all elements before any ray is sent; rays that `kept` holds are not traced
    /// again.
    pub fn keeping(
        elements: &'a Elements,
        visibility: &'a Visibility,
        kept: Option<&mut KeptBlocks>,
        ranks: &'a Ranks,
    ) -> Self {
        let numbers = || (0..elements.list().len() as u64).collect();
        let kept = kept.and_then(|kept| kept.take_rays(0, 1, numbers(), ranks));
        Self::new(elements, visibility, ranks).with_kept(kept)
    }

    /// The transport by the rays of the scene before, where that can be; `kept` was moved to this scene.
    pub fn standing(
        elements: &'a Elements,
        visibility: &'a Visibility,
        accuracy: Accuracy,
        standing: &mut StandingRays,
        kept: &mut KeptBlocks,
        work: &Work<'a>,
    ) -> Option<Self> {
        let (state, exact_pairs) = standing.moved(elements, visibility, accuracy, kept, work)?;
        let State { senders, pilot, sent, rays, counts, tally, worth, .. } = state;
        let starts = elements.starts();
        let held = HeldRows::of(work.ranks, &starts);
        Some(Self {
            elements,
            visibility,
            senders,
            sent,
            pilot,
            starts,
            counts,
            ranks: work.ranks,
            held,
            tally,
            exact_pairs,
            worth,
            only: None,
            unhidden: UnhiddenPairs::default(),
            kept: None,
            rays: Some(rays),
        })
    }

    /// Leaves its rays to the next scene, and to `kept` what they met where that cannot be.
    pub fn keep_standing(mut self, standing: &mut StandingRays, kept: &mut KeptBlocks) {
        let rays = self.rays.take().or_else(|| self.standing_rays());
        let Some((rays, elements)) = rays.zip(kept.shared_elements()) else {
            return self.keep_rays(Some(kept));
        };
        if let Some(rays) = self.kept.take() {
            kept.count_rays(rays.counts(), self.ranks);
        }
        let Self { senders, pilot, sent, counts, tally, exact_pairs, worth, .. } = self;
        let exact = exact_pairs.pairs().clone();
        standing.keep(State { elements, senders, pilot, sent, rays, counts, tally, worth, exact });
    }

    /// The rays that count, of the elements from which this rank sends; None where what they met is not
    /// known.
    fn standing_rays(&self) -> Option<Vec<ElementRays>> {
        let kept = self.kept.as_ref()?;
        let own = |element: usize| element % self.ranks.count() == self.ranks.number();
        let rays = (0..self.senders.len()).into_par_iter().map(|element| {
            if !own(element) {
                return Some(ElementRays::default());
            }
            let hits = kept.hits(element);
            let [first, end] = [self.pilot[element], self.sent[element]];
            let ray =
                |index: u64| StandingRay::new(&self.senders[element].departure(index), hits[index as usize]);
            (hits.len() as u64 == end).then(|| (first..end).map(ray).collect())
        });
        let rays: Option<_> = rays.collect();
        if self.ranks.any(rays.is_none()) { None } else { rays }
    }

    /// Leaves to `kept` what its rays met.
    pub fn keep_rays(self, kept: Option<&mut KeptBlocks>) {
        if let (Some(kept), Some(rays)) = (kept, self.kept) {
            kept.put_rays(0, rays, self.ranks);
        }
    }

    /// Rays sent by each element so far.
    pub fn sent(&self) -> &[u64] {
        &self.sent
    }

    /// Pairs of elements on which rays have landed since the pilot round, or so far, if that has not ended; those that
    /// this rank counts.
    pub fn pairs_met(&self) -> usize {
        self.tally.len()
    }

    /// Whether rays carry a pair, the element that comes first in front.
    pub fn is_by_rays(&self, pair: [usize; 2]) -> bool {
        let is_covered = pair.iter().any(|element| self.elements.list()[*element].contact.is_some());
        !is_covered && self.counts(pair.map(|element| element as u32).into())
    }

    /// Share of the rays of each element that count on no pair: they met nothing, or a back, or a pair that
    /// is carried exactly.
    pub fn shares_lost(&self) -> Vec<f64> {
        let list = self.elements.list().iter().zip(&self.counts.weights).zip(&self.starts);
        let share = |((element, weights), start): ((&Element, &[f64; 2]), &usize)| {
            let Counts { missed, exact, .. } = &self.counts;
            let lost = missed[0][*start] + missed[1][*start] + exact[0][*start] + exact[1][*start];
            lost * element.area.sqrt() / (weights[0] + weights[1]).max(f64::MIN_POSITIVE)
        };
        list.map(share).collect()
    }

    /// Sends so many more rays from each element; covered elements send none. `goes_on` gets the number done;
    /// false ends the sending.
    pub fn send(&mut self, rays: &[u64], goes_on: &mut dyn FnMut(u64) -> bool) {
        self.ranks.note_choice(&rays);
        let list = self.elements.list();
        let tasks = rays.iter().enumerate().filter(|(element, _)| list[*element].contact.is_none());
        let tasks: Vec<RayTask> = tasks
            .flat_map(|(element, rays)| {
                let sent = self.sent[element];
                (0..*rays).step_by(TASK as usize).map(move |first| RayTask {
                    element,
                    first: sent + first,
                    count: TASK.min(rays - first),
                })
            })
            .collect();
        let (mut rest, mut done) = (&tasks[..], 0);
        while !rest.is_empty() {
            let mut total = 0;
            let mut fits = |task: &RayTask| {
                total += task.count;
                total <= CHUNK
            };
            let count = rest.iter().take_while(|task| fits(task)).count().max(1);
            let (now, later) = rest.split_at(count);
            self.run(now);
            done += now.iter().map(|task| task.count).sum::<u64>();
            if !goes_on(done) {
                return;
            }
            rest = later;
        }
    }

    /// Ends the pilot round before so many rays are sent from each element: pairs are carried exactly for
    /// which that costs less than the rays that would land on them, and of pairs with few hits to come only a
    /// part of their entries is counted. The pilot's own hits are forgotten: pairs that got many by chance
    /// are among those chosen.
    pub fn settle(&mut self, planned: &[u64], accuracy: Accuracy, work: &Work<'_>) {
        self.settle_again(planned, accuracy, None, work);
    }

    /// Settles as [`SampledTransport::settle`], to the bit; exact pairs that `kept` holds are not
    /// integrated again.
    pub fn settle_again(
        &mut self,
        planned: &[u64],
        accuracy: Accuracy,
        kept: Option<&mut KeptBlocks>,
        work: &Work<'_>,
    ) {
        self.ranks.note_choice(&(planned, accuracy));
        let list = self.elements.list();
        let density = |index: usize| {
            let area = list[index].area;
            [
                planned[index] as f64 / area,
                (self.counts.weights[index][0] + self.counts.weights[index][1]) / area,
            ]
        };
        let expected = |sums: &Sums| {
            let [[a, b], [c, d]] = [density(sums.row), density(sums.column)];
            f64::from(sums.hits) * (a + c) / (b + d)
        };
        let pairs = ExactPairs::worth(self.elements, self.visibility, &self.tally, &self.held, &expected);
        self.worth.clone_from(&pairs);
        self.exact_pairs = ExactPairs::new(pairs, self.elements, self.visibility, accuracy, kept, work);
        self.tally.settle(list, &expected);
        self.pilot.clone_from(&self.sent);
        self.counts = Counts::new(list.len(), self.elements.coefficients());
    }

    /// Number of pairs that are carried exactly.
    pub fn exact_pairs(&self) -> usize {
        self.exact_pairs.len()
    }

    /// Largest error of the exact pairs, as [`BlockStatistics::accuracy_reached`](radiosity_kernel::BlockStatistics).
    pub fn exact_accuracy(&self) -> f64 {
        self.exact_pairs.accuracy_reached()
    }

    /// Sends the rays of these tasks, each rank those of some of them, and counts what became of all.
    fn run(&mut self, tasks: &[RayTask]) {
        let ranks = self.ranks;
        let makers = self.makers(tasks, ranks.count());
        let sent = ranks.made(PartName::Rays, &makers, |task| self.sent_by(&tasks[task]));
        let own = tasks.iter().zip(&makers).filter(|(_, maker)| **maker == ranks.number());
        let own: Vec<&RayTask> = own.map(|(task, _)| task).collect();
        ranks.count_work(0, own.iter().map(|task| task.count).sum());
        if let Some(kept) = &mut self.kept {
            let own = own.iter().zip(&sent);
            own.for_each(|(task, sent)| kept.insert(task.element, task.first, &sent.hits, sent.recalled));
        }
        let sums = sent.into_iter().map(|sent| sent.sums).collect();
        // Each rank sends those of one task after the other.
        let parcels = ranks.exchange(self.parcels(sums, ranks.count()));
        let mut parcels: Vec<_> = parcels.into_iter().map(Vec::into_iter).collect();
        let mut hits = Vec::new();
        for (RayTask { element, count, .. }, maker) in tasks.iter().zip(makers) {
            let own = parcels[maker].next().expect("each rank ran its tasks");
            self.sent[*element] += count;
            self.counts.add(*element, self.starts[*element], &own.sums);
            hits.extend(own.hits);
        }
        self.tally.take(self.elements.list(), &hits);
    }

    /// The rank, of so many, that runs each task: as even as can be; or where it is to know the hits of rays,
    /// the same for all rays of an element.
    fn makers(&self, tasks: &[RayTask], ranks: usize) -> Vec<usize> {
        if self.kept.is_some() {
            return tasks.iter().map(|task| task.element % ranks).collect();
        }
        let counts: Vec<f64> = tasks.iter().map(|task| task.count as f64).collect();
        let ends = shares::ends(&counts, ranks);
        (0..tasks.len()).map(|task| shares::owner(&ends, task)).collect()
    }

    /// The part of `sums` that each of so many ranks counts: the hits of elements of which it holds the
    /// pairs, and all else.
    fn parcels(&self, sums: Vec<RaySums>, ranks: usize) -> Vec<Vec<RaySums>> {
        if self.held.ranks().are_alone() {
            return vec![sums; ranks];
        }
        let counted = |rank: usize, sums: &RaySums| {
            let is_counted = |hit: &&Hit| hit.is_counted_by(rank, &self.held);
            RaySums { hits: sums.hits.iter().filter(is_counted).copied().collect(), ..sums.without_hits() }
        };
        (0..ranks).map(|rank| sums.iter().map(|sums| counted(rank, sums)).collect()).collect()
    }

    /// Sends the rays of a task.
    fn sent_by(&self, task: &RayTask) -> SentRays {
        let sender = &self.senders[task.element];
        let element = &self.elements.list()[task.element];
        let hits = Vec::with_capacity(task.count as usize);
        let mut sent = SentRays {
            sums: RaySums { sums: ElementSums::nothing(element.basis.len()), hits },
            hits: Vec::with_capacity(if self.kept.is_some() { task.count as usize } else { 0 }),
            recalled: 0,
        };
        for index in task.first..task.first + task.count {
            check_interrupt_at(index);
            let departure = sender.departure(index);
            let half = (index % 2) as usize;
            let encounter = self.first_hit(task.element, index, &departure, &mut sent);
            let hit_by = |met| hit(self.elements, task.element, index, &departure, met);
            let hidden = self.unhidden.hidden(element, &departure, encounter.as_ref());
            let hidden = hidden.and_then(|hidden| hit_by(Some(hidden)));
            let hit = hit_by(encounter);
            let is_exact = hit.is_some_and(|hit| !self.counts(hit.pair()));
            let ray = CountedRay { element, departure: &departure, half, sign: 1.0 };
            let RaySums { sums, hits } = &mut sent.sums;
            let is_unhidden = |hit: &Hit| self.unhidden.first_entry(hit.pair()).is_some();
            hits.extend(sums.count(ray, hit, is_exact).filter(|hit| !is_unhidden(hit)));
            hits.extend(hidden.filter(is_unhidden));
        }
        sent
    }

    /// First hit of a ray: as known from the scene before, or else as traced.
    fn first_hit(
        &self,
        element: usize,
        index: u64,
        departure: &Departure,
        sent: &mut SentRays,
    ) -> Option<Encounter> {
        let (origin, direction) = (departure.node.position, departure.direction);
        let surface = self.elements.list()[element].surface;
        let found = || self.visibility.nearest_from(surface, origin, direction);
        let Some(kept) = &self.kept else { return found() };
        let recalled = kept.get(element, index, [origin, direction]);
        sent.recalled += u64::from(recalled.is_some());
        let encounter = recalled.unwrap_or_else(found);
        sent.hits.push(KeptHit::of(encounter.as_ref()));
        encounter
    }

    /// Whether rays count on a pair, the element that comes first in front.
    fn counts(&self, pair: (u32, u32)) -> bool {
        self.only.as_ref().map_or_else(|| !self.exact_pairs.holds(pair), |only| only.contains(&pair))
    }

    /// Blocks of the pairs on which rays count, given those of all others.
    pub(crate) fn beside(&self, others: &Fixed) -> Blocks {
        let mut blocks = Blocks::empty(self.starts.clone(), true, self.held.ranks());
        self.estimate(others, Rays::All).push(&mut blocks);
        blocks
    }

    /// The blocks by some of the rays, beside the `fixed` ones.
    fn estimate(&self, fixed: &Fixed, rays: Rays) -> Estimate<'_> {
        let Self { tally, unhidden, held, .. } = self;
        let counted = Counted { tally, unhidden, held, rays };
        Estimate::new(self.elements.list(), &self.starts, counted, &self.counts, fixed)
    }

    /// Estimate of G by the rays sent since the pilot round, or so far, if that has not ended.
    pub fn blocks(&self, rays: Rays) -> Blocks {
        let list = self.elements.list();
        let mut blocks = Blocks::empty(self.starts.clone(), true, self.ranks);
        self.exact_pairs.append_to(&mut blocks);
        self.push_covered(&mut blocks);
        let exact = blocks.apply(&self.elements.constant());
        let fixed = Fixed { sums: &exact, error: EXACT, blocks: &blocks };
        let estimate = self.estimate(&fixed, rays);
        let integrated = estimate.projections(&vec![1.0; list.len()]);
        blocks.integrated = Some(integrated.iter().zip(exact).map(|(a, b)| a + b).collect());
        estimate.push(&mut blocks);
        self.exact_pairs.add_reports(&mut blocks);
        blocks.statistics.rays = self.sent.iter().sum();
        blocks
    }

    /// The exact blocks of what lies on each other.
    fn push_covered(&self, blocks: &mut Blocks) {
        let list = self.elements.list();
        let mut by_contact: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (index, contact) in (0..).zip(list).filter_map(|(index, own)| Some((index, own.contact?))) {
            by_contact.entry(contact).or_default().push(index);
        }
        for (row, element) in list.iter().enumerate() {
            let others = element.contact.and_then(|contact| by_contact.get(&contact)).into_iter().flatten();
            for column in others.copied().filter(|column| *column > row) {
                blocks.push(row, column, &covering::block(element, &list[column]).values);
            }
        }
    }
}
