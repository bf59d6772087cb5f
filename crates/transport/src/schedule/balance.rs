//! The distribution of blocks over ranks, so that all have about as much to do.
//!
//! What a block costs is known only afterwards: near and partly hidden pairs cost a hundred times as much as
//! others. The blocks are therefore made in three rounds. A pilot tells what the blocks of each class cost;
//! by that most are shared; the rest go to the ranks that turn out to have done less. Within a round the
//! dearest blocks are shared first, each to the rank with the least ([`radiosity_work::ranks::shares`]).

use std::collections::HashMap;
use std::ops::AddAssign;

use radiosity_kernel::blocks::block::BlockReport;
use radiosity_work::ranks::shares;

/// Blocks for each one that the pilot makes, by which the costs of the others are estimated. With fewer
/// pilots the estimates are worse; with more less is left to even out.
const PILOT: usize = 16;

/// Blocks for each one that evens out what ranks have done: a fifth of the work bears estimates that are off
/// by as much.
const REST: usize = 5;

/// Kernel samples that take as long as a segment tested for visibility: some 20 ns and .4 µs.
const SAMPLES_A_RAY: f64 = 20.0;

/// Cost of an integral beside its samples, in samples.
const START: f64 = 50.0;

/// Cost of blocks.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cost {
    /// Kernel samples: terms of quadrature rules.
    pub samples: u64,
    /// Segments tested for visibility.
    pub rays: u64,
}

impl Cost {
    pub(super) fn of(block: &BlockReport) -> Self {
        Self { samples: block.samples, rays: block.rays }
    }

    /// Number of kernel samples that take as long.
    pub fn in_samples(self) -> f64 {
        self.samples as f64 + SAMPLES_A_RAY * self.rays as f64
    }
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        self.samples += other.samples;
        self.rays += other.rays;
    }
}

/// A block before it is made.
#[derive(Clone, Copy, Debug)]
pub(super) struct WorkItem {
    /// Blocks of one class cost about the same.
    pub(super) class: u64,
    /// The price of a pair with its blockers (rays), of use where nothing is known of its class.
    pub(super) price: f64,
}

/// Work of the ranks so far, and costs of blocks by class.
#[derive(Debug)]
pub(super) struct Balance {
    /// Cost of what each rank has made.
    loads: Vec<f64>,
    classes: HashMap<u64, Class>,
    /// Prices and costs of all blocks.
    prices: f64,
    costs: f64,
}

/// The blocks of a class that were made.
#[derive(Clone, Copy, Debug, Default)]
struct Class {
    number: f64,
    /// Their cost (samples).
    cost: f64,
}

/// The rounds in which so many blocks are made by so many ranks: one where there is nobody to share them
/// with.
pub(super) fn rounds(items: usize, ranks: usize) -> Vec<Vec<usize>> {
    if ranks == 1 {
        return vec![(0..items).collect()];
    }
    let (pilot, others): (Vec<usize>, Vec<usize>) = (0..items).partition(|place| place % PILOT == 0);
    let (rest, most): (Vec<usize>, Vec<usize>) = others.into_iter().partition(|place| place % REST == 0);
    vec![pilot, most, rest]
}

impl Balance {
    /// The balance of so many ranks before anything is made.
    pub(super) fn new(ranks: usize) -> Self {
        Self { loads: vec![0.0; ranks], classes: HashMap::new(), prices: 0.0, costs: 0.0 }
    }

    /// The ranks that make the blocks of a round.
    pub(super) fn share(&self, round: &[usize], items: &[WorkItem]) -> Vec<usize> {
        let costs: Vec<f64> = round.iter().map(|place| self.cost(&items[*place])).collect();
        shares::beside(&self.loads, &costs)
    }

    /// Takes note of what a block cost.
    pub(super) fn take(&mut self, maker: usize, item: &WorkItem, block: &BlockReport) {
        let cost = START + Cost::of(block).in_samples();
        self.loads[maker] += cost;
        let class = self.classes.entry(item.class).or_default();
        class.number += 1.0;
        class.cost += cost;
        self.prices += item.price;
        self.costs += cost;
    }

    /// Expected cost of a block, in samples: the mean of others of its class, or by its price.
    fn cost(&self, item: &WorkItem) -> f64 {
        match self.classes.get(&item.class) {
            Some(class) => class.cost / class.number,
            None if self.prices > 0.0 => item.price * self.costs / self.prices,
            None => item.price,
        }
    }
}
