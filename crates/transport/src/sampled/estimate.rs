//! Blocks from the sums over hits.
//!
//! With W_i the rays of element i (the sum of their weights) and D_ij = W_i/A_i + W_j/A_j,
//! G_ij = S_ij / D_ij; of a pair of which hidden rays alone are counted S_ij is what D_ij tells of the block if
//! nothing were hidden, less their sums ([`unhidden_pairs`](super::unhidden_pairs)). Two things are known beside
//! it: the rays of i that count on no pair, and how these are spread over i, tell the projections
//!
//! ```text
//! t_i^k = ∫ φ_k s dA = c_i^k − (A_i/W_i) Σ w φ_k(x)   over the rays that count on no pair ,
//! ```
//!
//! of s, the part of the hemisphere that sampled pairs fill; so do the rays that meet nothing, less what
//! exact pairs fill. Where no ray is lost this is exact. The blocks tell them too, as Σ_j G_ij c_j. By their
//! variances, α = V/(V + V_own) with
//!
//! ```text
//! V_i = Σ_j max(1, n_ij) / D_ij² ,     V_own,i = A_i² p (1 − p) / W_i ,
//! ```
//!
//! p the share of rays that are not lost, the better of the two counts: Σ_j G_ij c_j + α (t_i − Σ_j G_ij c_j).
//! For k = 0 factors d_i G_ij d_j bring it about ([`closure`]); for k > 0 what is missing is spread over the
//! entries G_ij^k0 in the proportions of the exchanges. G stays symmetric, and a closed scene keeps its power.

use std::collections::HashSet;

use radiosity_elements::Element;
use radiosity_kernel::Blocks;
use radiosity_kernel::blocks::held_rows::HeldRows;
use radiosity_work::interruption::check_interrupt;
use serde::{Deserialize, Serialize};

use crate::sampled::closure;
use crate::sampled::closure::Exchange;
use crate::sampled::element_sums::ElementSums;
use crate::sampled::rays::Rays;
use crate::sampled::tally::{Sums, Tally};
use crate::sampled::unhidden_pairs::UnhiddenPairs;

/// Sums over the rays of each element: those sent, those that met no front, those on exact pairs.
#[derive(Debug)]
pub(super) struct Counts {
    /// Sum of the weights of the rays of each element, in either half.
    pub weights: Vec<[f64; 2]>,
    /// Σ w φ_k(x) over the rays that met no front, of all coefficients, in either half.
    pub missed: [Vec<f64>; 2],
    /// Σ w φ_k(x) over the rays that landed on pairs that are carried exactly, of all coefficients, in either
    /// half.
    pub exact: [Vec<f64>; 2],
}

impl Counts {
    /// Sums of no rays yet, of so many elements and coefficients.
    pub(super) fn new(elements: usize, coefficients: usize) -> Self {
        let nothing = || [vec![0.0; coefficients], vec![0.0; coefficients]];
        Self { weights: vec![[0.0; 2]; elements], missed: nothing(), exact: nothing() }
    }

    /// Adds sums over rays of an element, whose first coefficient this is.
    pub(super) fn add(&mut self, element: usize, start: usize, own: &ElementSums) {
        for half in 0..2 {
            self.weights[element][half] += own.weights[half];
            for (sums, more) in [(&mut self.missed, &own.missed), (&mut self.exact, &own.exact)] {
                sums[half][start..].iter_mut().zip(&more[half]).for_each(|(sum, value)| *sum += value);
            }
        }
    }
}

/// The sums over hits, and which of them count.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counted<'a> {
    /// The sums over the pairs of which this rank holds one of the elements.
    pub tally: &'a Tally,
    /// The pairs of which the hits are those that are hidden.
    pub unhidden: &'a UnhiddenPairs,
    pub held: &'a HeldRows,
    pub rays: Rays,
}

/// A pair on which rays count, as all ranks know it.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct PairEstimate {
    exchange: Exchange,
    /// n_ij / D_ij².
    variance: f64,
    is_cross: bool,
    /// Whether all its sums are zero.
    is_zero: bool,
}

/// Blocks from the sums over some of the rays.
#[derive(Debug)]
pub(super) struct Estimate<'a> {
    list: &'a [Element],
    starts: &'a [usize],
    counted: Counted<'a>,
    /// Relative error of the pairs on which no ray counts.
    error: f64,
    /// Pairs that rays would be counted on if they were hidden, and none was.
    wholly_seen: Vec<(u32, u32)>,
    /// W_i, the sum of the weights of the rays of each element.
    weights: Vec<f64>,
    /// V_own,i, the variance of an element's total exchange by its own rays (length⁴).
    variances: Vec<f64>,
    /// t_i^k, the projections of s by the element's own rays, of all coefficients (length).
    known: Vec<f64>,
}

/// Corrections of blocks by what is known beside the sums over hits.
struct Corrections {
    /// d_i, the closure factor of each element.
    factors: Vec<f64>,
    /// α (t_i^k − Σ_j d_i G_ij d_j c_j), the defect of each row sum of a coefficient k > 0.
    tilts: Vec<f64>,
    /// Row sums after the factors.
    totals: Vec<f64>,
}

/// The pairs on which no ray counts: their blocks are known.
#[derive(Debug)]
pub(crate) struct Fixed<'a> {
    /// Σ_j G_ij c_j over these pairs, of all coefficients.
    pub sums: &'a [f64],
    /// Error of these sums, relative to row sums.
    pub error: f64,
    /// The blocks of these pairs.
    pub blocks: &'a Blocks,
}

impl Counted<'_> {
    /// The pairs of which hidden rays alone are counted, and none was met.
    fn wholly_seen(&self) -> Vec<(u32, u32)> {
        let unhidden: HashSet<(u32, u32)> = self.unhidden.pairs().collect();
        let met = self.tally.iter().map(|sums| sums.pair()).filter(|pair| unhidden.contains(pair));
        let met: HashSet<(u32, u32)> = met.collect();
        self.unhidden.pairs().filter(|pair| !met.contains(pair)).collect()
    }
}

impl<'a> Estimate<'a> {
    /// The estimate by the rays that count.
    pub(super) fn new(
        list: &'a [Element],
        starts: &'a [usize],
        counted: Counted<'a>,
        counts: &Counts,
        fixed: &Fixed,
    ) -> Self {
        let rays = counted.rays;
        let weights: Vec<f64> = counts.weights.iter().map(|halves| rays.of(*halves)).collect();
        let all = |halves: &[Vec<f64>; 2]| -> Vec<f64> {
            halves[0].iter().zip(&halves[1]).map(|(even, odd)| rays.of([*even, *odd])).collect()
        };
        let (missed, exact) = (all(&counts.missed), all(&counts.exact));
        let wholly_seen = counted.wholly_seen();
        let [variances, known] = [Vec::new(), Vec::new()];
        let mut estimate =
            Self { list, starts, counted, error: fixed.error, wholly_seen, weights, variances, known };
        for index in 0..list.len() {
            let range = starts[index]..starts[index + 1];
            estimate.take(index, &missed[range.clone()], &exact[range], fixed);
        }
        estimate
    }

    /// Takes what own rays tell of the next element, from what they missed, what landed on pairs on which
    /// none counts, and the blocks of these.
    fn take(&mut self, index: usize, missed: &[f64], exact: &[f64], fixed: &Fixed) {
        check_interrupt();
        let error = if fixed.blocks.is_complete(index) { fixed.error } else { f64::INFINITY };
        let fixed = &fixed.sums[self.starts[index]..self.starts[index + 1]];
        let (element, weight) = (&self.list[index], self.weights[index]);
        if weight == 0.0 {
            self.variances.push(f64::INFINITY);
            self.known.extend(missed.iter().map(|_| 0.0));
            return;
        }
        let root = element.constant[0];
        let variance = |lost: f64| {
            // Half a ray is added on either side: no share is known to be 0 or 1.
            let share = (weight - root * lost + 0.5) / (weight + 1.0);
            element.area * element.area * (share * (1.0 - share)).max(0.0) / weight
        };
        let counted = variance(missed[0] + exact[0]);
        let unsure = if error.is_finite() { error * root * fixed[0] } else { error };
        let total = variance(missed[0]) + unsure * unsure;
        let by_missed = total < counted;
        self.variances.push(total.min(counted));
        let known = (0..missed.len()).map(|k| {
            let whole = if k == 0 { root } else { 0.0 };
            let lost = if by_missed { missed[k] } else { missed[k] + exact[k] };
            whole - element.area / weight * lost - if by_missed { fixed[k] } else { 0.0 }
        });
        self.known.extend(known.collect::<Vec<f64>>());
    }

    /// Adds the blocks to `blocks`.
    pub(super) fn push(&self, blocks: &mut Blocks) {
        let estimates = self.pair_estimates();
        let exchanges: Vec<Exchange> = estimates.iter().map(|pair| pair.exchange).collect();
        let trust = self.trust(&estimates);
        let factors = closure::factors(&exchanges, &self.wanted(&exchanges, &trust), self.error);
        let tilts = self.tilts(&factors, &trust);
        let totals = closure::row_sums(&exchanges, &factors);
        let corrections = Corrections { factors, tilts, totals };
        let mut own = self.pairs().peekable();
        for PairEstimate { exchange, is_cross, is_zero, .. } in &estimates {
            check_interrupt();
            let (row, column) = (exchange.row as usize, exchange.column as usize);
            let held = own.next_if(|(sums, _)| (sums.row, sums.column) == (row, column));
            match (held, is_cross) {
                (Some((sums, density)), true) => {
                    blocks.push_cross(row, column, &self.values(&sums, density, exchange, &corrections));
                }
                (Some((sums, density)), false) => {
                    blocks.push(row, column, &self.values(&sums, density, exchange, &corrections));
                }
                (None, true) => blocks.pass_cross(row, column),
                (None, false) if *is_zero => {}
                (None, false) => blocks.pass(row, column),
            }
        }
    }

    /// The values of a block: S_ij / D_ij, corrected.
    fn values(&self, sums: &Sums, density: f64, exchange: &Exchange, how: &Corrections) -> Vec<f64> {
        let Corrections { factors, tilts, totals } = how;
        let Sums { row, column, .. } = *sums;
        let factor = factors[row] * factors[column];
        let mut values = self.sums(sums, density);
        values.iter_mut().for_each(|value| *value = factor * *value / density);
        let amount = factor * exchange.amount;
        let columns = self.list[column].basis.len();
        if amount > 0.0 {
            let [own, other] = [(row, column), (column, row)]
                .map(|(tilted, far)| amount / (totals[tilted] * self.list[far].constant[0]));
            for k in 1..self.list[row].basis.len() {
                values[sums.place(k, columns)] += own * tilts[self.starts[row] + k];
            }
            for l in 1..columns {
                values[l] += other * tilts[self.starts[column] + l];
            }
        }
        values
    }

    /// Σ_j d_i G_ij d_j c_j for factors d, of all coefficients; each rank sums those of its elements.
    pub(super) fn projections(&self, factors: &[f64]) -> Vec<f64> {
        let mut projected = vec![0.0; self.known.len()];
        for (sums, density) in self.pairs() {
            let Sums { row, column, .. } = sums;
            let values = self.sums(&sums, density);
            let factor = factors[row] * factors[column] / density;
            let [rows, columns] = [row, column].map(|index| self.list[index].basis.len());
            for k in 0..rows {
                let value = values[sums.place(k, columns)];
                projected[self.starts[row] + k] += factor * value * self.list[column].constant[0];
            }
            if row != column {
                for l in 0..columns {
                    projected[self.starts[column] + l] += factor * values[l] * self.list[row].constant[0];
                }
            }
        }
        self.counted.held.complete(&mut projected);
        projected
    }

    /// The pairs in the rows of all ranks, rank by rank.
    fn pair_estimates(&self) -> Vec<PairEstimate> {
        let Counted { held, rays, .. } = self.counted;
        let estimate = |(sums, density): (Sums<'_>, f64)| {
            let values = self.sums(&sums, density);
            PairEstimate {
                exchange: self.exchange(&sums, values[0], density),
                variance: rays.share() * f64::from(sums.hits.max(1)) / (density * density),
                is_cross: sums.is_cross,
                is_zero: values.iter().all(|sum| *sum == 0.0),
            }
        };
        let own: Vec<PairEstimate> =
            self.pairs().filter(|(sums, _)| held.has(sums.row)).map(estimate).collect();
        held.ranks().all(own).concat()
    }

    /// The pairs on which rays count and of which this rank holds an element, with D_ij.
    fn pairs(&self) -> impl Iterator<Item = (Sums<'_>, f64)> {
        let density = |index: usize| self.weights[index] / self.list[index].area;
        let unmet =
            self.wholly_seen.iter().map(|(row, column)| Sums::nothing(*row as usize, *column as usize));
        let pairs = self.counted.tally.iter().chain(unmet);
        let pairs = pairs.map(move |sums| (sums, density(sums.row) + density(sums.column)));
        pairs.filter(|(_, density)| *density > 0.0)
    }

    /// S_ij, row-major, or as told by `is_cross`.
    fn sums(&self, sums: &Sums, density: f64) -> Vec<f64> {
        let Counted { unhidden, rays, .. } = self.counted;
        let Some(first) = unhidden.first_entry(sums.pair()) else { return rays.sums(sums).collect() };
        let mut seen = vec![0.0; self.list[sums.row].basis.len() * self.list[sums.column].basis.len()];
        seen[0] = density * first;
        seen.iter_mut().zip(rays.sums(sums)).for_each(|(seen, hidden)| *seen -= hidden);
        seen
    }

    /// A_i F_ij = ∫ φ_0 dA_i G_ij^00 ∫ φ_0 dA_j, with the first of the sums.
    fn exchange(&self, sums: &Sums, first: f64, density: f64) -> Exchange {
        let [a, b] = [sums.row, sums.column].map(|index| &self.list[index]);
        let amount = a.constant[0] * first * b.constant[0] / density;
        Exchange { row: sums.row as u32, column: sums.column as u32, amount }
    }

    /// α_i, the weight of an element's own rays in its row sum, in [0, 1].
    fn trust(&self, estimates: &[PairEstimate]) -> Vec<f64> {
        let mut variances = vec![0.0; self.list.len()];
        for PairEstimate { exchange, variance, .. } in estimates {
            variances[exchange.row as usize] += variance;
            variances[exchange.column as usize] += variance;
        }
        let trust = |(index, variance): (usize, f64)| match variance {
            0.0 => 0.0,
            variance => variance / (variance + self.variances[index]),
        };
        variances.into_iter().enumerate().map(trust).collect()
    }

    /// Row sums by blocks and by own rays, weighted by `trust` in the latter.
    fn wanted(&self, exchanges: &[Exchange], trust: &[f64]) -> Vec<f64> {
        let sums = closure::row_sums(exchanges, &vec![1.0; self.list.len()]);
        let known = |index: usize| self.list[index].constant[0] * self.known[self.starts[index]];
        let wanted = |(index, sum): (usize, f64)| sum + trust[index] * (known(index) - sum);
        sums.into_iter().enumerate().map(wanted).collect()
    }

    /// α (t_i^k − Σ_j d_i G_ij d_j c_j) for k > 0.
    fn tilts(&self, factors: &[f64], trust: &[f64]) -> Vec<f64> {
        let mut tilts = self.projections(factors);
        for (range, trust) in self.starts.windows(2).zip(trust) {
            let own = tilts[range[0]..range[1]].iter_mut().zip(&self.known[range[0]..range[1]]);
            own.for_each(|(tilt, known)| *tilt = trust * (known - *tilt));
        }
        tilts
    }
}
