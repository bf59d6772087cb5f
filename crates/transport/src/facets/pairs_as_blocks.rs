//! Exchanges of facets as blocks, and as blocks that are off by what the exchanges err by.
//!
//! With the deviation d of each exchange, a sign by chance for each pair and a part of it,
//!
//! ```text
//! G_ij = (x ± part · d) / √(A_i A_j) .
//! ```
//!
//! Half the difference of what follows from the parts 1 and −1 is about the error of what follows from 0.

use radiosity_elements::Elements;
use radiosity_elements::sampling::shift::shift;
use radiosity_kernel::Blocks;
use radiosity_work::ranks::Ranks;

use super::{BY_POINTS, FacetExchanges, MixedPair};

impl FacetExchanges {
    /// The blocks between `elements`, off by this part of their deviations.
    pub fn blocks(&self, elements: &Elements, part: f64, ranks: &Ranks) -> Blocks {
        let list = elements.list();
        let mut blocks = Blocks::empty(elements.starts(), true, ranks);
        let mut sums = vec![0.0; list.len()];
        let ratio = self.mixed_ratio();
        for (row, pairs) in self.rows.iter().enumerate() {
            let mut mixed = pairs.mixed().peekable();
            for (column, exchange) in pairs.exchanges.iter() {
                let known = mixed.next_if(|(other, _)| *other == column).map(|(_, pair)| *pair);
                let of_pair = known.map_or(0.0, |pair| {
                    let area = list[row].area.min(list[column].area);
                    pair.deviation(self.stands_for(&pair, area), ratio)
                });
                let deviation = of_pair.hypot(BY_POINTS * exchange);
                [row, column].iter().for_each(|end| sums[*end] += deviation * deviation);
                let moved = match part {
                    0.0 => exchange,
                    part => (exchange + sign(row, column) * part * deviation).max(0.0),
                };
                blocks.push(row, column, &[moved / (list[row].area * list[column].area).sqrt()]);
            }
        }
        let reached = sums.iter().zip(list).map(|(sum, element)| sum.sqrt() / element.area);
        blocks.statistics.accuracy_reached = reached.fold(0.0, f64::max);
        blocks.statistics.pairs = self.pairs;
        blocks.statistics.pairs.by_rays = self.rows.iter().map(|row| row.mixed().count()).sum();
        (blocks.statistics.samples, blocks.statistics.distinct) = (self.samples, self.samples);
        blocks.statistics.rays = self.segments;
        blocks
    }

    /// Pairs of the kind of one between facets of which this is the smaller area, for each that shows it, of which all
    /// first segments were stopped and no more were sent.
    pub fn stands_for(&self, pair: &MixedPair, area: f64) -> f64 {
        if pair.whole <= self.decided * area { pair.missed(self.first) } else { 0.0 }
    }

    /// Pairs of which a part is seen to be hidden for each that was looked at again and whose segments agree.
    fn mixed_ratio(&self) -> f64 {
        let pairs = || self.rows.iter().flat_map(|row| row.mixed());
        let mixed = pairs().filter(|(_, pair)| pair.is_mixed()).count();
        (mixed as f64 + 1.0) / ((pairs().count() - mixed) as f64 + 1.0)
    }
}

impl MixedPair {
    /// Whether a part of it is seen to be hidden.
    pub fn is_mixed(&self) -> bool {
        self.part > 0.0 && self.part < 1.0
    }

    /// Pairs of its kind for each that shows it, of which so many first segments were all stopped.
    fn missed(&self, first: u64) -> f64 {
        let [seen, hidden] = [self.part, 1.0 - self.part].map(|part| f64::from(part).powi(first as i32));
        hidden / (1.0 - hidden - seen).max(f64::MIN_POSITIVE)
    }

    /// Deviation of its exchange (length²), with that of so many pairs that it stands for; where its segments
    /// agree, the root of the mean square, if so many pairs are hidden in part for each of which segments
    /// agree.
    fn deviation(&self, missed: f64, ratio: f64) -> f64 {
        let (part, variance) = (f64::from(self.part), f64::from(self.variance));
        if self.is_mixed() {
            return self.whole * (variance + part * part * missed).sqrt();
        }
        let scale = variance.sqrt();
        self.whole * scale * (2.0 * ratio * scale / (1.0 - scale)).min(1.0).sqrt()
    }
}

/// 1 or −1 by chance, the same for a pair each time.
fn sign(row: usize, column: usize) -> f64 {
    let [chance] = shift::<1>(((row as u64) << 32) ^ column as u64);
    if chance < 0.5 { -1.0 } else { 1.0 }
}
