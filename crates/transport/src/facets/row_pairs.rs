//! The pairs of a facet with those after it.

use serde::{Deserialize, Serialize};

use crate::row_exchanges::RowExchanges;

/// The pairs of a facet with those after it that exchange anything.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct RowPairs {
    /// Their exchanges.
    pub exchanges: RowExchanges,
    /// Places of those that were looked at again.
    mixed: Vec<u32>,
    /// Findings of these.
    pairs: Vec<MixedPair>,
}

/// A pair that was looked at again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MixedPair {
    /// Its exchange if nothing hid a part of it (length²).
    pub whole: f64,
    /// The part v that nothing hides.
    pub part: f32,
    /// The variance of v; where it is 0 or 1, the square of its error at the most.
    pub variance: f32,
}

impl RowPairs {
    /// Appends a pair that is clear.
    pub(super) fn push(&mut self, column: usize, exchange: f64) {
        self.exchanges.push(column, exchange);
    }

    /// Appends a pair that is to be looked at again.
    pub(super) fn push_open(&mut self, column: usize, exchange: f64) {
        self.mixed.push(self.exchanges.count() as u32);
        self.push(column, exchange);
    }

    /// Gives back what it has no need of.
    pub(super) fn shrink(&mut self) {
        self.exchanges.shrink();
        self.mixed.shrink_to_fit();
    }

    /// Columns and exchanges of the pairs that are to be looked at again.
    pub(super) fn opened(&self) -> impl Iterator<Item = (usize, f64)> {
        self.mixed.iter().filter_map(|place| self.exchanges.at(*place as usize))
    }

    /// Takes what was found of these.
    pub(super) fn settle(&mut self, pairs: Vec<MixedPair>) {
        for (place, pair) in self.mixed.iter().zip(&pairs) {
            self.exchanges.set(*place as usize, pair.whole * f64::from(pair.part));
        }
        self.pairs = pairs;
    }

    /// Columns of the pairs that were looked at again, and what is known of these.
    pub fn mixed(&self) -> impl Iterator<Item = (usize, &MixedPair)> {
        self.opened().map(|(column, _)| column).zip(&self.pairs)
    }
}
