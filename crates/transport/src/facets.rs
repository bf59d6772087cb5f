//! Exchanges of many small flat elements of constants, pair by pair: what nothing hides of a pair, by points or by a
//! contour, times the part of it that segments see,
//!
//! ```text
//! A_i F_ij = ∫∫ κ dA dA · v ,     v = Σ κ_k V_k / Σ κ_k     over segments k from points of i to points of j .
//! ```
//!
//! Rays spread over the hemisphere land on each of N elements with 1/N of them, which tells a factor of 10⁻⁴ badly;
//! here each pair has segments of its own, unless it is clear. The first ones decide about many: none is free. Others
//! get as many as their error needs, for e below a part of the largest factor of either row,
//!
//! ```text
//! e² = ∫∫ κ² · Σ κ_k² (V_k − v)² / (Σ κ_k)² .
//! ```
//!
//! That part is what is asked for, or as little as so many segments allow (`pair_need`).
//!
//! Most pairs are clear: nothing can stand between them, which is looked up for two clusters, for a facet and a
//! cluster, and for the pairs that these leave open. Where n segments of another pair agree, and any part of it may
//! be hidden, one more would not agree with probability 1/(n + 2) (P.-S. Laplace's rule of succession), and by that
//! part of the whole the exchange may err: n follows from the error asked for, and from the share of the pair in a row.
//!
//! Pairs of which a part is hidden, and all of the first segments are stopped, are missed. A pair of a known part v,
//! neither 0 nor 1, would have been missed by k independent segments with the probability p = (1 − v)ᵏ, and stands for
//! p/(1 − p) pairs that were (D. Horvitz, D. Thompson, *J. Am. Stat. Assoc.* 47 (1952) 663-685).

mod facet;
mod clusters;
mod cluster_sight;
mod segments;
mod row_pairs;
mod row_size;
mod pair_need;
mod pairs_as_blocks;
#[cfg(test)]
mod tests;

use radiosity_elements::Elements;
use radiosity_elements::sampling::shift::shift;
use radiosity_kernel::PairCounts;
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicUsize, Ordering};

use cluster_sight::{ClusterSight, FacetSight};
use clusters::Clusters;
use facet::Facet;
use pair_need::{PairNeed, affordable};
pub use row_pairs::{MixedPair, RowPairs};
use row_size::RowSize;
use segments::{Segments, TOGETHER};

/// Segments by which all pairs would be decided about at [`USUAL_EPS`] if none was clear, and of one pair at least and
/// at the most. Chosen: ten thousand triangles that hide each other take two minutes of one thread.
const FIRST_OF_ALL: f64 = 5e8;
const FEWEST_FIRST: f64 = 4.0;
const MOST_FIRST: f64 = 16.0;

/// Accuracy for which these are the numbers.
const USUAL_EPS: f64 = 1e-3;

/// Part of so many segments that tells as much as they do. Chosen: kernels of most pairs differ by less.
const TELLING: f64 = 0.75;

/// Segments for each that tells as much as one of one kernel from which their ends are drawn. Chosen: drawing takes as
/// long as a half of the segment, and leaves their spread over both facets less even.
const UNEVEN: f64 = 4.0;

/// Most segments of a pair of which hardly any carry something.
const MOST_IDLE: u64 = 512;

/// Segments of a pair over those that told how many it needs, at the most. Chosen.
const MORE: u64 = 4;

/// Segments of further looks at [`USUAL_EPS`], for each facet and in all at the most. Chosen: a furnished room of six
/// thousand polygons takes a minute of one thread.
const FURTHER_OF_EACH: f64 = 2.5e4;
const FURTHER_OF_ALL: f64 = 1.5e8;

/// Segments that a pair would have if all agree from which it is looked up by itself whether it is clear. Chosen: a
/// look takes as long as so many.
const ALONE: u64 = 64;

/// Seconds of two threads that a pair takes, those near a facet, and a segment; and further segments of a pair between
/// which something may stand. Measured on balls and a furnished room.
const PAIR: f64 = 4e-7;
const NEAR: f64 = 2.5e-4;
const SEGMENT: f64 = 2.5e-7;
const AGAIN: f64 = 50.0;

/// Pairs by which the time is told.
const LOOKED_AT: u64 = 2_000;

/// Relative error of points at the least distance at which they are taken, at the most. Measured: 1.1e-3 of four
/// thousand pairs of triangles.
const BY_POINTS: f64 = 1.5e-3;

/// All flat elements of a scene, each with points for rules and segments.
#[derive(Debug)]
pub struct FacetTransport<'a> {
    elements: &'a Elements,
    visibility: &'a Visibility,
    facets: Vec<Facet>,
    clusters: Clusters,
    /// Segments that decide about a pair where all agree.
    first: u64,
    /// Segments of further looks at all pairs.
    further: f64,
    /// Error that is asked for, over the largest factor of a row.
    eps: f64,
    work: &'a Work<'a>,
}

/// Exchanges of all pairs of facets.
#[derive(Debug)]
pub struct FacetExchanges {
    /// The pairs of each facet with those after it.
    pub rows: Vec<RowPairs>,
    /// Segments that decided about a pair where all agreed.
    pub first: u64,
    /// Largest unhidden exchange, over the smaller area of both, of pairs about which these decided alone.
    pub decided: f64,
    /// Numbers of pairs by how they were treated.
    pub pairs: PairCounts,
    /// Evaluations of the kernel, or of logarithms in contour integrals.
    pub samples: u64,
    /// Segments that were tested.
    pub segments: u64,
    /// Pairs by contours that are clear.
    pub exact: usize,
}

/// Counts of the pairs of a row.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
struct Counts {
    pairs: PairCounts,
    samples: u64,
    segments: u64,
    exact: usize,
}

/// Findings of the first segments of a row.
#[derive(Debug, Serialize, Deserialize)]
struct FirstLook {
    pairs: RowPairs,
    /// Exchanges of those that the first ones leave open, if nothing hid a part of them (length²).
    whole: Vec<f64>,
    counts: Counts,
}

/// Findings of further segments of the open pairs of a row.
#[derive(Debug, Default, Serialize, Deserialize)]
struct SecondLook {
    pairs: Vec<MixedPair>,
    segments: u64,
    /// Pairs of which a part is hidden.
    partly_hidden: usize,
}

impl<'a> FacetTransport<'a> {
    /// The transport between all elements, to about `eps` of the largest factor of a row where a part of a pair is
    /// hidden; None where one is bent, or covers another.
    pub fn new(
        elements: &'a Elements,
        visibility: &'a Visibility,
        eps: f64,
        work: &'a Work<'a>,
    ) -> Option<Self> {
        let list = elements.list();
        let finer = (USUAL_EPS / eps).max(1.0);
        let pairs = 0.5 * (list.len() as f64).powi(2);
        let first = (finer * FIRST_OF_ALL / pairs).clamp(FEWEST_FIRST, finer * MOST_FIRST) as u64;
        let facets =
            list.iter().zip(0..).map(|(element, number)| Facet::of(element, number, first.max(TOGETHER)));
        let facets = facets.collect::<Option<Vec<Facet>>>()?;
        Some(Self {
            elements,
            visibility,
            clusters: Clusters::of(&facets),
            facets,
            first,
            further: finer * (FURTHER_OF_EACH * list.len() as f64).min(FURTHER_OF_ALL),
            eps,
            work,
        })
    }

    /// About the seconds that two threads take.
    pub fn seconds(&self) -> f64 {
        let facets = self.facets.len() as f64;
        let pairs = 0.5 * facets.powi(2);
        let open = pairs * self.part_open();
        let segments = open * self.first as f64 + (AGAIN * open).min(self.further);
        NEAR * facets + PAIR * pairs + SEGMENT * segments
    }

    /// The part of all pairs that see each other unless something hides them, and between which something may stand, by
    /// some of them.
    fn part_open(&self) -> f64 {
        let count = self.facets.len() as f64;
        let is_open = |number: &u64| {
            check_interrupt();
            let [one, other] = shift::<2>(*number).map(|place| &self.facets[(place * count) as usize]);
            one.sight_of(other).is_some() && !self.visibility.is_clear_of_all([one.end(), other.end()])
        };
        (0..LOOKED_AT).filter(is_open).count() as f64 / LOOKED_AT as f64
    }

    /// The exchanges of the `wanted` pairs.
    pub fn exchanges(&self, wanted: &(dyn Fn(usize, usize) -> bool + Sync)) -> FacetExchanges {
        let count = self.facets.len();
        let done = AtomicUsize::new(0);
        let tell =
            || self.work.report_done(Stage::Blocks, done.fetch_add(1, Ordering::Relaxed) + 1, 2 * count);
        let first = |cluster: usize| {
            let mut sight = ClusterSight::of(&self.facets, &self.clusters, self.visibility, cluster);
            let look = |row: &u32| {
                let row = *row as usize;
                let found = self.first_look(row, sight.of_facet(row), wanted);
                tell();
                found
            };
            self.clusters.list()[cluster].members.iter().map(look).collect::<Vec<_>>()
        };
        let length = |row: &u32| (count - *row as usize) as f64;
        let lengths = self.clusters.list().iter().map(|own| own.members.iter().map(length).sum());
        let looks = self.work.ranks.map(PartName::Facets, &lengths.collect::<Vec<f64>>(), first);
        let mut looks = self.by_rows(looks);
        let sizes = self.row_sizes(&looks);
        let eps = self.affordable(&looks, &sizes);
        let again: Vec<f64> = looks.iter().map(|look| 1.0 + look.whole.len() as f64).collect();
        let second = |row: usize| {
            let found = self.second_look(row, &looks[row], &sizes, eps);
            tell();
            found
        };
        let found = self.work.ranks.map(PartName::Facets, &again, second);
        let mut counts = Counts::default();
        for (look, second) in looks.iter_mut().zip(found) {
            counts.add(&look.counts);
            counts.segments += second.segments;
            counts.pairs.partly_hidden += second.partly_hidden;
            look.pairs.settle(second.pairs);
        }
        let Counts { pairs, samples, segments, exact } = counts;
        FacetExchanges {
            rows: looks.into_iter().map(|look| look.pairs).collect(),
            first: self.first,
            decided: pair_need::largest(self.first, self.eps),
            pairs,
            samples,
            segments,
            exact,
        }
    }

    /// The looks at the members of each cluster, in the order of the facets.
    fn by_rows(&self, looks: Vec<Vec<FirstLook>>) -> Vec<FirstLook> {
        let mut looks: Vec<_> = looks.into_iter().map(Vec::into_iter).collect();
        let next = |row: usize| looks[self.clusters.of_facet(row).0].next().expect("each member has one");
        (0..self.facets.len()).map(next).collect()
    }

    /// The pairs of a facet with those after it, by the first segments.
    fn first_look(
        &self,
        row: usize,
        mut own_sight: FacetSight<'_, '_>,
        wanted: &(dyn Fn(usize, usize) -> bool + Sync),
    ) -> FirstLook {
        let mut look = FirstLook { pairs: RowPairs::default(), whole: Vec::new(), counts: Counts::default() };
        let own = &self.facets[row];
        let list = self.elements.list();
        for (column, other) in self.facets.iter().enumerate().skip(row + 1) {
            check_interrupt();
            if !wanted(row, column) {
                look.counts.pairs.skipped_black += 1;
                continue;
            }
            let Some(sight) = own.sight_of(other) else {
                look.counts.pairs.skipped_behind += 1;
                continue;
            };
            let (whole, samples) = if sight.is_far {
                own.by_points(other)
            } else {
                facet::by_contour([&list[row], &list[column]])
            };
            look.counts.samples += samples;
            let passage = own_sight.past(column);
            if passage.is_open() {
                look.push(column, whole, sight.is_far);
                continue;
            }
            let mut segments = self.segments(row, column);
            segments.send(1);
            let part = whole / own.area.min(other.area);
            let is_asked = !segments.are_none_free()
                && (!passage.is_unknown() || part >= pair_need::largest(ALONE, self.eps));
            let is_clear = is_asked && passage.is_clear([own, other], self.visibility);
            if !is_clear {
                segments.send(self.first);
            }
            look.counts.segments += segments.sent();
            let is_told = part <= pair_need::largest(self.first, self.eps)
                && segments.carrying() >= TELLING * FEWEST_FIRST;
            match is_told && segments.are_none_free() {
                true => look.counts.pairs.skipped_hidden += 1,
                false if is_clear => look.push(column, whole, sight.is_far),
                false => look.push_open(column, whole, sight.is_far, &segments),
            }
        }
        look.counts.pairs.total = self.facets.len() - row - 1;
        look.pairs.shrink();
        look
    }

    /// The size of each row.
    fn row_sizes(&self, looks: &[FirstLook]) -> Vec<RowSize> {
        let mut sizes = vec![RowSize::default(); looks.len()];
        for (row, look) in looks.iter().enumerate() {
            for (column, exchange) in look.pairs.exchanges.iter() {
                sizes[row].take(exchange);
                sizes[column].take(exchange);
            }
        }
        sizes
    }

    /// The error of open pairs over the largest of their rows that the segments of further looks afford.
    fn affordable(&self, looks: &[FirstLook], sizes: &[RowSize]) -> f64 {
        let of_row = |(row, look): (usize, &'_ FirstLook)| {
            let open = look.pairs.opened().zip(&look.whole);
            let need = |((column, exchange), whole): ((usize, f64), &f64)| {
                (PairNeed::of(*whole, [sizes[row], sizes[column]]), (exchange / whole) as f32)
            };
            open.map(need).collect::<Vec<_>>()
        };
        let pairs: Vec<_> = looks.iter().enumerate().flat_map(of_row).collect();
        affordable(&pairs, self.eps, self.first, self.further)
    }

    /// As many segments as the open pairs of a row need for this error over the largest.
    fn second_look(&self, row: usize, look: &FirstLook, sizes: &[RowSize], eps: f64) -> SecondLook {
        let mut found = SecondLook::default();
        for ((column, _), whole) in look.pairs.opened().zip(&look.whole) {
            check_interrupt();
            let need = PairNeed::of(*whole, [sizes[row], sizes[column]]);
            let mut segments = self.segments(row, column);
            self.look_again(&mut segments, need, eps);
            let (part, variance) = (segments.part() as f32, segments.variance() as f32);
            let pair = MixedPair { whole: *whole, part, variance };
            found.segments += segments.sent();
            found.partly_hidden += usize::from(pair.is_mixed());
            found.pairs.push(pair);
        }
        found
    }

    /// Sends as many segments as a pair needs for this error over the largest of its rows.
    fn look_again(&self, segments: &mut Segments<'_>, need: PairNeed, eps: f64) {
        let fewest = need.fewest(eps, self.first);
        segments.send(fewest);
        if segments.spread() > UNEVEN {
            segments.choose_ends();
            segments.send(fewest);
        }
        while segments.carrying() < TELLING * fewest as f64 && segments.sent() < MOST_IDLE {
            segments.send(2 * segments.sent());
        }
        if segments.agree() {
            segments
                .send((need.agreeing(eps) as f64 * segments.spread()).min(pair_need::most() as f64) as u64);
        }
        // The spread of few segments tells little of how many are needed.
        let needed = |segments: &Segments| (segments.needed(need.error(eps)) as u64).min(pair_need::most());
        while !segments.agree() && segments.sent() < needed(segments) {
            segments.send(needed(segments).min(MORE * segments.sent()));
        }
    }

    fn segments(&self, row: usize, column: usize) -> Segments<'_> {
        let surface = self.elements.list()[row].surface;
        Segments::between(&self.facets[row], &self.facets[column], surface, self.visibility)
    }

    /// Relative error of exchanges between what nothing hides, at the most.
    pub fn error_of_points() -> f64 {
        BY_POINTS
    }
}

impl Counts {
    fn add(&mut self, other: &Self) {
        self.pairs.add(&other.pairs);
        self.samples += other.samples;
        self.segments += other.segments;
        self.exact += other.exact;
    }
}

impl FirstLook {
    /// Takes a pair that is clear.
    fn push(&mut self, column: usize, whole: f64, is_far: bool) {
        self.count(is_far);
        self.counts.exact += usize::from(!is_far);
        self.pairs.push(column, whole);
    }

    /// Takes a pair of which the first segments tell this.
    fn push_open(&mut self, column: usize, whole: f64, is_far: bool, segments: &Segments) {
        self.count(is_far);
        self.pairs.push_open(column, whole * segments.part());
        self.whole.push(whole);
    }

    fn count(&mut self, is_far: bool) {
        match is_far {
            true => self.counts.pairs.separated += 1,
            false => self.counts.pairs.contour += 1,
        }
    }
}
