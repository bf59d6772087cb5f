//! The pairs of a facet with those after it.

use serde::{Deserialize, Serialize};

/// The pairs of a facet with those after it that exchange anything: columns ascending, and exchanges (length²).
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct RowPairs {
    /// The other facet of each pair.
    pub columns: Vec<u32>,
    /// A_i F_ij (length²).
    pub exchanges: Vec<f64>,
    /// Places of those of which a part is hidden.
    mixed: Vec<u32>,
    /// What is known of these.
    pairs: Vec<MixedPair>,
}

/// A pair of which a part is hidden.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct MixedPair {
    /// Its exchange if nothing hid a part of it (length²).
    pub whole: f64,
    /// The part v that nothing hides.
    pub part: f32,
    /// The variance of v.
    pub variance: f32,
}

impl RowPairs {
    /// Appends a pair that is seen wholly.
    pub(super) fn push(&mut self, column: usize, exchange: f64) {
        self.columns.push(column as u32);
        self.exchanges.push(exchange);
    }

    /// Appends a pair of which a part is hidden.
    pub(super) fn push_mixed(&mut self, column: usize, exchange: f64) {
        self.mixed.push(self.columns.len() as u32);
        self.push(column, exchange);
    }

    /// Gives back what it has no need of.
    pub(super) fn shrink(&mut self) {
        self.columns.shrink_to_fit();
        self.exchanges.shrink_to_fit();
        self.mixed.shrink_to_fit();
    }

    /// The columns of the pairs of which a part is hidden.
    pub(super) fn mixed_columns(&self) -> impl Iterator<Item = usize> {
        self.mixed.iter().map(|place| self.columns[*place as usize] as usize)
    }

    /// Takes what was found of these.
    pub(super) fn settle(&mut self, pairs: Vec<MixedPair>) {
        for (place, pair) in self.mixed.iter().zip(&pairs) {
            self.exchanges[*place as usize] = pair.whole * f64::from(pair.part);
        }
        self.pairs = pairs;
    }

    /// The pairs: columns and exchanges.
    pub fn iter(&self) -> impl Iterator<Item = (usize, f64)> {
        self.columns.iter().zip(&self.exchanges).map(|(column, exchange)| (*column as usize, *exchange))
    }

    /// Columns of the pairs of which a part is hidden, and what is known of these.
    pub fn mixed(&self) -> impl Iterator<Item = (usize, &MixedPair)> {
        self.mixed_columns().zip(&self.pairs)
    }
}
