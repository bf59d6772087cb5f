//! How well transfers keep reciprocity, A_i F_ij = A_j F_ji.
//!
//! Each pair is integrated once and stored once, so that the stored transfers keep it by construction. It says something of the
//! rules only where a pair is integrated again with the roles of the two elements exchanged: the outer integral is then the inner
//! one. A sample of the pairs tells.

use serde::{Deserialize, Serialize};

/// What a sample of pairs that were integrated both ways tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reciprocity {
    /// How many pairs of elements were integrated both ways.
    pub pairs: usize,
    /// Largest |A_i F_ij − A_j F_ji| / min(A_i, A_j) of them.
    pub largest: f64,
}

impl Reciprocity {
    /// Counts a pair whose two view factors differ by that much, relative to the smaller area.
    pub(crate) fn take(&mut self, difference: f64) {
        self.pairs += 1;
        self.largest = self.largest.max(difference);
    }
}
