//! Wholes between which view factors are asked for: single elements, or surfaces.
//!
//! With exchanges A_I F_IJ = Σ √(A_i A_j) G_ij over the elements i of I and j of J, between constants; of
//! single elements all entries of G count.

use std::collections::HashMap;

use radiosity_elements::Element;
use radiosity_kernel::blocks::FirstEntry;

use super::ray_block::RayBlock;
use crate::schedule::FactorEnds;
use crate::tolerances::{BATCHES, DEVIATIONS};

/// The wholes of a scene.
pub(super) struct Wholes {
    kind: FactorEnds,
    /// The whole of each element.
    of: Vec<usize>,
    /// The area of each whole.
    areas: Vec<f64>,
}

impl Wholes {
    pub(super) fn new(list: &[Element], kind: FactorEnds) -> Self {
        let of: Vec<usize> = match kind {
            FactorEnds::Element => (0..list.len()).collect(),
            FactorEnds::Surface => list.iter().map(|element| element.surface).collect(),
        };
        let mut areas = vec![0.0; of.iter().map(|whole| whole + 1).max().unwrap_or(0)];
        of.iter().zip(list).for_each(|(whole, element)| areas[*whole] += element.area);
        Self { kind, of, areas }
    }

    /// The largest view factor of each whole.
    pub(super) fn largest_factors(
        &self,
        list: &[Element],
        others: &[FirstEntry],
        found: &[RayBlock],
    ) -> Vec<f64> {
        let mut exchanges: HashMap<[usize; 2], f64> = HashMap::new();
        let mut take = |row: usize, column: usize, value: f64| {
            let exchange = value * (list[row].area * list[column].area).sqrt();
            let [one, other] = self.wholes([row, column]);
            *exchanges.entry([one, other]).or_default() += exchange;
            if row != column && one == other {
                // Both directions are within the same whole.
                *exchanges.entry([one, other]).or_default() += exchange;
            }
        };
        others.iter().for_each(|first| take(first.row, first.column, first.value));
        found.iter().for_each(|found| take(found.row, found.column, found.values[0]));
        let mut rows = vec![0.0f64; self.areas.len()];
        for ([one, other], exchange) in exchanges {
            rows[one] = rows[one].max(exchange.abs() / self.areas[one]);
            rows[other] = rows[other].max(exchange.abs() / self.areas[other]);
        }
        rows
    }

    /// The error of a pair as if it were all that its wholes exchange, relative to the largest of their rows.
    pub(super) fn relative(&self, list: &[Element], rows: &[f64], found: &RayBlock) -> f64 {
        let unit = (list[found.row].area * list[found.column].area).sqrt();
        let most = (found.values[0].abs() + found.error) * unit;
        self.relative_to(rows, self.wholes([found.row, found.column]), found.error * unit, most)
    }

    /// Sets the errors of every pair: that of the exchange of its wholes, of which `firsts` are the
    /// first entries by each batch.
    pub(super) fn judge(
        &self,
        list: &[Element],
        rows: &[f64],
        found: &mut [RayBlock],
        firsts: &[[f64; BATCHES]],
    ) {
        if self.kind == FactorEnds::Element {
            for found in found {
                found.relative = self.relative(list, rows, found);
                found.share = found.error * (list[found.row].area * list[found.column].area).sqrt();
            }
            return;
        }
        let mut sums: HashMap<[usize; 2], BatchExchange> = HashMap::new();
        for (found, firsts) in found.iter().zip(firsts) {
            let unit = (list[found.row].area * list[found.column].area).sqrt();
            let pair = self.wholes([found.row, found.column]);
            let twice = if pair[0] == pair[1] && found.row != found.column { 2.0 } else { 1.0 };
            sums.entry(pair).or_default().take(firsts, found.one, twice * unit);
        }
        for found in found {
            let pair = self.wholes([found.row, found.column]);
            let Estimate { mean, error } = sums[&pair].estimate();
            found.share = error / sums[&pair].blocks.sqrt();
            found.relative = self.relative_to(rows, pair, error, mean.abs() + error);
        }
    }

    /// The wholes of two elements, in ascending order.
    fn wholes(&self, pair: [usize; 2]) -> [usize; 2] {
        let [a, b] = pair.map(|element| self.of[element]);
        [a.min(b), a.max(b)]
    }

    /// The larger of the errors of the two view factors, each over the largest of its row. The exchange
    /// itself may be as large as `most`: where nothing is known of a row, an exchange of which nothing is
    /// known is in error by all of it.
    fn relative_to(&self, rows: &[f64], pair: [usize; 2], error: f64, most: f64) -> f64 {
        let relative = |whole: usize| {
            let largest = rows[whole].max(most / self.areas[whole]);
            error / self.areas[whole] / largest.max(f64::MIN_POSITIVE)
        };
        relative(pair[0]).max(relative(pair[1]))
    }
}

/// The exchange of two wholes by each batch.
#[derive(Clone, Copy, Debug, Default)]
struct BatchExchange {
    batches: [f64; BATCHES],
    /// Value of one ray in the exchange (length²), the largest of the pairs.
    one: f64,
    /// Number of its blocks.
    blocks: f64,
}

/// The exchange of two wholes, as the batches estimate it (length²).
struct Estimate {
    mean: f64,
    error: f64,
}

impl BatchExchange {
    fn take(&mut self, firsts: &[f64; BATCHES], one: f64, unit: f64) {
        self.batches.iter_mut().zip(firsts).for_each(|(sum, first)| *sum += unit * first);
        self.one = self.one.max(unit * one);
        self.blocks += 1.0;
    }

    fn estimate(&self) -> Estimate {
        let n = BATCHES as f64;
        let mean = self.batches.iter().sum::<f64>() / n;
        let square = self.batches.iter().map(|batch| (batch - mean).powi(2)).sum::<f64>();
        Estimate { mean, error: DEVIATIONS * (square / (n * (n - 1.0))).sqrt() + self.one }
    }
}
