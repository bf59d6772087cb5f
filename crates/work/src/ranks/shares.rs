//! The distribution of pieces of work over ranks.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

/// The rank of each piece of work: the dearest first, each to the rank with the least so far (R. L. Graham,
/// *SIAM J. Appl. Math.* 17 (1969) 416-429: at most 4/3 of the best possible longest time). Costs are ≥ 0 and
/// finite, in any unit.
pub fn by_cost(costs: &[f64], ranks: usize) -> Vec<usize> {
    beside(&vec![0.0; ranks], costs)
}

/// The rank of each piece of work, as by [`by_cost`], for ranks that have so much to do already: the loads
/// are in the unit of the costs.
pub fn beside(loads: &[f64], costs: &[f64]) -> Vec<usize> {
    if loads.len() == 1 {
        return vec![0; costs.len()];
    }
    let mut order: Vec<usize> = (0..costs.len()).collect();
    order.sort_by(|a, b| costs[*b].total_cmp(&costs[*a]).then(a.cmp(b)));
    let mut loads: BinaryHeap<Reverse<(Load, usize)>> =
        loads.iter().enumerate().map(|(rank, load)| Reverse((Load(*load), rank))).collect();
    let mut owners = vec![0; costs.len()];
    for piece in order {
        let Reverse((Load(load), rank)) = loads.pop().expect("there is a rank");
        owners[piece] = rank;
        loads.push(Reverse((Load(load + costs[piece]), rank)));
    }
    owners
}

/// Cost of the work of a rank so far, which orders ranks.
#[derive(Clone, Copy, Debug)]
struct Load(f64);

impl PartialEq for Load {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Load {}

impl PartialOrd for Load {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Load {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// Cuts a row of things of these weights (≥ 0) into one part for each rank, as even as they can be one after
/// the other: the ends of the parts.
pub fn ends(weights: &[f64], ranks: usize) -> Vec<usize> {
    let all: f64 = weights.iter().sum();
    let mut ends = Vec::with_capacity(ranks);
    let (mut end, mut sum) = (0, 0.0);
    for rank in 1..=ranks {
        let goal = all * rank as f64 / ranks as f64;
        while end < weights.len() && (rank == ranks || sum + 0.5 * weights[end] <= goal) {
            sum += weights[end];
            end += 1;
        }
        ends.push(end);
    }
    ends
}

/// The part of a rank.
pub fn range(ends: &[usize], rank: usize) -> Range<usize> {
    let start = if rank == 0 { 0 } else { ends[rank - 1] };
    start..ends[rank]
}

/// The rank in whose part a thing is.
pub fn owner(ends: &[usize], thing: usize) -> usize {
    ends.partition_point(|end| *end <= thing)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn no_rank_has_more_than_four_thirds_of_the_bound(
            costs in prop::collection::vec(0.0..10.0f64, 0..200),
            ranks in 1..9usize,
        ) {
            let owners = by_cost(&costs, ranks);
            let load = |rank| -> f64 {
                costs.iter().zip(&owners).filter(|(_, owner)| **owner == rank).map(|(cost, _)| cost).sum()
            };
            let most = (0..ranks).map(load).fold(0.0, f64::max);
            let largest = costs.iter().copied().fold(0.0, f64::max);
            // Graham: no more than the mean and (1 − 1/n) of the last piece.
            prop_assert!(most <= costs.iter().sum::<f64>() / ranks as f64 + largest * (1.0 - 1.0 / ranks as f64) + 1e-9);
        }

        #[test]
        fn parts_cover_everything_once(weights in prop::collection::vec(0.0..10.0f64, 0..100), ranks in 1..9usize) {
            let ends = ends(&weights, ranks);
            prop_assert_eq!(ends.len(), ranks);
            let parts: Vec<usize> = (0..ranks).flat_map(|rank| range(&ends, rank)).collect();
            prop_assert_eq!(parts, (0..weights.len()).collect::<Vec<_>>());
            for thing in 0..weights.len() {
                prop_assert!(range(&ends, owner(&ends, thing)).contains(&thing));
            }
            let largest = weights.iter().copied().fold(0.0, f64::max);
            let even = weights.iter().sum::<f64>() / ranks as f64;
            for rank in 0..ranks {
                prop_assert!(weights[range(&ends, rank)].iter().sum::<f64>() <= even + largest + 1e-9);
            }
        }
    }
}
