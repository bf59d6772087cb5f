//! Blocks from rays: who sees whom is answered for all pairs of a row at once.
//!
//! Element i sends n_i rays, from points x spread evenly over its area A_i in cosine-distributed directions. A ray that first
//! meets the front of element j at y has the density (1/A_i) κ V, the shape of the integrand, from either end. Combined with the rays
//! from j by the balance heuristic,
//!
//! ```text
//! G_ij^kl ≈ Σ φ_k(x) φ_l(y) / (n_i/A_i + n_j/A_j)   over all rays i → j and j → i ,
//! ```
//!
//! without bias, symmetric, each ray used in both directions; backs absorb. Row sums are then made to agree with the shares of rays
//! that hit something ([`closure`]). The rays of even and of odd number are two estimates of their own: half of what they differ by
//! is about the error of their mean.
//!
//! Pairs on which many rays would land are carried by the exact rules, if that costs less ([`strong`]).
//!
//! What lies on another surface exchanges with it alone, exactly ([`crate::transport::rules::covering`]), and sends no rays.
//!
//! References: A. Keller, *Quasi-Monte Carlo radiosity*, EGWR 1996, 101-110; E. Veach, L. Guibas, SIGGRAPH 1995, 419-428 (the balance
//! heuristic); Ph. Bekaert, *Hierarchical and stochastic algorithms for radiosity*, K. U. Leuven 1999.

mod closure;
mod sender;
mod hit;
mod tally;
mod strong;

use rayon::prelude::*;

use crate::elements::{Element, Elements};
use crate::transport::blocks::Blocks;
use crate::transport::blocks::block::Accuracy;
use crate::transport::rules::covering;
use crate::visibility::Visibility;
use closure::Exchange;
use hit::{Hit, hit};
use sender::Sender;
use strong::Strong;
use tally::{Sums, Tally};

/// Rays whose hits are held at a time: some 30 MB.
const CHUNK: u64 = 1 << 19;

/// Rays that one task sends.
const TASK: u64 = 1 << 12;

/// Which rays an estimate of G takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rays {
    /// All.
    All,
    /// Those of even number.
    Even,
    /// Those of odd number.
    Odd,
}

/// Rays sent so far between elements, and what they met.
#[derive(Debug)]
pub struct SampledTransport<'a> {
    elements: &'a Elements,
    visibility: &'a Visibility,
    senders: Vec<Sender>,
    /// Rays sent by each element.
    sent: Vec<u64>,
    /// Sum of the weights of the rays of each element, in either half.
    weights: Vec<[f64; 2]>,
    /// The same of those that met a front.
    met: Vec<[f64; 2]>,
    tally: Tally,
    strong: Strong,
}

/// Rays of one element, one after the other.
#[derive(Clone, Copy, Debug)]
struct Task {
    element: usize,
    first: u64,
    count: u64,
}

impl<'a> SampledTransport<'a> {
    /// No rays yet.
    pub fn new(elements: &'a Elements, visibility: &'a Visibility) -> Self {
        let list = elements.list();
        let senders = list.par_iter().enumerate().map(|(place, element)| Sender::new(element, place));
        Self {
            elements,
            visibility,
            senders: senders.collect(),
            sent: vec![0; list.len()],
            weights: vec![[0.0; 2]; list.len()],
            met: vec![[0.0; 2]; list.len()],
            tally: Tally::new(list.len()),
            strong: Strong::default(),
        }
    }

    /// Rays sent by each element so far.
    pub fn sent(&self) -> &[u64] {
        &self.sent
    }

    /// Share of the rays of each element that met a front; 0 where none was sent.
    pub fn shares_met(&self) -> Vec<f64> {
        (0..self.sent.len()).map(|element| self.share_met(element, Rays::All)).collect()
    }

    fn share_met(&self, element: usize, rays: Rays) -> f64 {
        match chosen_of(self.weights[element], rays) {
            0.0 => 0.0,
            weight => chosen_of(self.met[element], rays) / weight,
        }
    }

    /// Sends so many more rays from each element; covered ones send none. `progress` hears how many are done.
    pub fn send(&mut self, rays: &[u64], progress: &mut dyn FnMut(u64)) {
        let list = self.elements.list();
        let tasks = rays.iter().enumerate().filter(|(element, _)| list[*element].contact.is_none());
        let mut tasks: Vec<Task> = tasks
            .flat_map(|(element, rays)| {
                let sent = self.sent[element];
                (0..*rays).step_by(TASK as usize).map(move |first| Task {
                    element,
                    first: sent + first,
                    count: TASK.min(rays - first),
                })
            })
            .collect();
        let (mut rest, mut done) = (&mut tasks[..], 0);
        while !rest.is_empty() {
            let mut total = 0;
            let mut fits = |task: &Task| {
                total += task.count;
                total <= CHUNK
            };
            let count = rest.iter().take_while(|task| fits(task)).count().max(1);
            let (now, later) = rest.split_at_mut(count);
            self.run(now);
            done += now.iter().map(|task| task.count).sum::<u64>();
            progress(done);
            rest = later;
        }
    }

    /// Ends the pilot round, if `more` times as many rays are to be sent in all as were: pairs are carried exactly for which that costs
    /// less than the rays that would land on them, and of pairs with few hits only a part of their entries is counted.
    pub fn settle(&mut self, more: f64, accuracy: Accuracy) {
        self.strong = Strong::choose(self.elements, self.visibility, &self.tally, more, accuracy);
        self.tally.settle(self.elements.list(), more);
    }

    /// Number of pairs that are carried exactly.
    pub fn exact_pairs(&self) -> usize {
        self.strong.len()
    }

    fn run(&mut self, tasks: &[Task]) {
        let results: Vec<([f64; 2], Vec<Hit>)> = tasks.par_iter().map(|task| self.hits(task)).collect();
        let mut hits = Vec::with_capacity(results.iter().map(|(_, hits)| hits.len()).sum());
        for (Task { element, count, .. }, (weights, own)) in tasks.iter().zip(results) {
            self.sent[*element] += count;
            self.weights[*element].iter_mut().zip(weights).for_each(|(sum, weight)| *sum += weight);
            own.iter().for_each(|hit| self.met[*element][hit.half as usize] += hit.weight);
            hits.extend(own);
        }
        hits.retain(|hit| !self.strong.holds(hit.source, hit.target));
        self.tally.take(self.elements.list(), &hits);
    }

    /// The weights of the rays of a task, by halves, and what they hit.
    fn hits(&self, task: &Task) -> ([f64; 2], Vec<Hit>) {
        let sender = &self.senders[task.element];
        let (mut weights, mut hits) = ([0.0; 2], Vec::new());
        for index in task.first..task.first + task.count {
            let departure = sender.departure(index);
            weights[(index % 2) as usize] += departure.weight;
            hits.extend(hit(self.elements, self.visibility, task.element, index, &departure));
        }
        (weights, hits)
    }

    /// Estimate of G by the rays sent so far.
    pub fn blocks(&self, rays: Rays) -> Blocks {
        let list = self.elements.list();
        let densities = self.densities(rays);
        let mut exchanges: Vec<Exchange> =
            self.sampled().map(|sums| exchange(list, &densities, &sums, rays)).collect();
        exchanges.extend(
            self.strong.iter().map(|(row, column, values)| exact_exchange(list, row, column, values[0])),
        );
        let wanted = self.wanted(rays);
        let factors = closure::factors(&exchanges, &wanted);
        let integrated = self.uncorrected(&densities, rays);
        let mut blocks = self.scaled(&densities, &factors, rays);
        blocks.integrated = Some(integrated);
        blocks.rays = self.sent.iter().sum();
        blocks
    }

    /// d_i G_ij d_j for the factors d.
    fn scaled(&self, densities: &[f64], factors: &[f64], rays: Rays) -> Blocks {
        let mut blocks = Blocks::empty(self.elements.starts(), true);
        let mut values = Vec::new();
        for sums in self.sampled() {
            let Sums { row, column, is_cross, halves, .. } = sums;
            let factor = factors[row] * factors[column] / (densities[row] + densities[column]);
            values.clear();
            values.extend(chosen(halves, rays).map(|sum| factor * sum));
            match is_cross {
                true => blocks.push_cross(row, column, &values),
                false => blocks.push(row, column, &values),
            }
        }
        self.strong.iter().for_each(|(row, column, values)| blocks.push(row, column, &values));
        self.push_covered(&mut blocks);
        blocks
    }

    /// What is known of the pairs that rays carry.
    fn sampled(&self) -> impl Iterator<Item = Sums<'_>> {
        self.tally.iter().filter(|sums| !self.strong.holds(sums.row as u32, sums.column as u32))
    }

    /// G c of the constant 1, before the row sums are corrected.
    fn uncorrected(&self, densities: &[f64], rays: Rays) -> Vec<f64> {
        let ones = vec![1.0; densities.len()];
        self.scaled(densities, &ones, rays).apply(&self.elements.constant())
    }

    /// n_i / A_i of the rays that count; n_i the sum of their weights, which is nearer to what hits are a share of than their number.
    fn densities(&self, rays: Rays) -> Vec<f64> {
        let weights = self.weights.iter().map(|halves| chosen_of(*halves, rays));
        weights.zip(self.elements.list()).map(|(weight, element)| weight / element.area).collect()
    }

    /// A_i s_i, s_i the share of rays that met a front.
    fn wanted(&self, rays: Rays) -> Vec<f64> {
        let list = self.elements.list().iter().enumerate();
        list.map(|(index, element)| element.area * self.share_met(index, rays)).collect()
    }

    /// The exact blocks of what lies on each other.
    fn push_covered(&self, blocks: &mut Blocks) {
        let list = self.elements.list();
        let covered: Vec<usize> = (0..list.len()).filter(|index| list[*index].contact.is_some()).collect();
        for (place, row) in covered.iter().enumerate() {
            for column in &covered[place + 1..] {
                if list[*row].contact == list[*column].contact {
                    blocks.push(*row, *column, &covering::block(&list[*row], &list[*column]).values);
                }
            }
        }
    }
}

/// The sums of the rays that count.
fn chosen(halves: [&[f32]; 2], rays: Rays) -> impl Iterator<Item = f64> {
    let halves = halves[0].iter().zip(halves[1]);
    halves.map(move |(even, odd)| chosen_of([*even, *odd].map(f64::from), rays))
}

fn chosen_of([even, odd]: [f64; 2], rays: Rays) -> f64 {
    match rays {
        Rays::All => even + odd,
        Rays::Even => even,
        Rays::Odd => odd,
    }
}

/// A_i F_ij = ∫ φ_0 dA_i G_ij^00 ∫ φ_0 dA_j.
fn exchange(list: &[Element], densities: &[f64], sums: &Sums, rays: Rays) -> Exchange {
    let Sums { row, column, halves, .. } = *sums;
    let sum = chosen_of([halves[0][0], halves[1][0]].map(f64::from), rays);
    let amount = match densities[row] + densities[column] {
        0.0 => 0.0,
        density => list[row].constant[0] * sum * list[column].constant[0] / density,
    };
    Exchange { exact: false, row: row as u32, column: column as u32, amount }
}

/// The exchange of a pair whose first entry is known.
fn exact_exchange(list: &[Element], row: usize, column: usize, entry: f64) -> Exchange {
    let amount = list[row].constant[0] * entry * list[column].constant[0];
    Exchange { exact: true, row: row as u32, column: column as u32, amount }
}
