//! The pairs of a facet with those after it.

use serde::{Deserialize, Serialize};

/// The pairs of a facet with those after it that exchange anything: columns ascending, and exchanges (length²).
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct RowPairs {
    /// The other facet of each pair.
    pub columns: Vec<u32>,
    /// A_i F_ij (length²).
    pub exchanges: Vec<f64>,
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
    /// Appends a pair that is seen wholly.
    pub(super) fn push(&mut self, column: usize, exchange: f64) {
        self.columns.push(column as u32);
        self.exchanges.push(exchange);
    }

    /// Appends a pair that is to be looked at again.
    pub(super) fn push_open(&mut self, column: usize, exchange: f64) {
        self.mixed.push(self.columns.len() as u32);
        self.push(column, exchange);
    }

    /// Gives back what it has no need of.
    pub(super) fn shrink(&mut self) {
        self.columns.shrink_to_fit();
        self.exchanges.shrink_to_fit();
        self.mixed.shrink_to_fit();
    }

    /// Places of the pairs that are to be looked at again.
    pub(super) fn open_places(&self) -> impl Iterator<Item = u32> {
        self.mixed.iter().copied()
    }

    /// Takes what was found of the pairs at these places.
    pub(super) fn settle(&mut self, places: Vec<u32>, pairs: Vec<MixedPair>) {
        for (place, pair) in places.iter().zip(&pairs) {
            self.exchanges[*place as usize] = pair.whole * f64::from(pair.part);
        }
        (self.mixed, self.pairs) = (places, pairs);
    }

    /// The pairs: columns and exchanges.
    pub fn iter(&self) -> impl Iterator<Item = (usize, f64)> {
        self.columns.iter().zip(&self.exchanges).map(|(column, exchange)| (*column as usize, *exchange))
    }

    /// Columns of the pairs that were looked at again, and what is known of these.
    pub fn mixed(&self) -> impl Iterator<Item = (usize, &MixedPair)> {
        self.mixed.iter().map(|place| self.columns[*place as usize] as usize).zip(&self.pairs)
    }

    /// Columns and exchanges of the pairs about which the first segments decided.
    pub fn decided(&self) -> impl Iterator<Item = (usize, f64)> {
        let mut mixed = self.mixed.iter().peekable();
        let pairs = self.iter().enumerate();
        pairs
            .filter(move |(place, _)| mixed.next_if(|other| **other as usize == *place).is_none())
            .map(|(_, pair)| pair)
    }
}
