//! Reciprocity A_i F_ij = A_j F_ji of the transfers, measured on a sample of pairs.
//!
//! Each pair is integrated and stored once, so that the stored transfers are reciprocal by construction. The
//! rules are tested only where a pair is integrated again with the roles of its elements exchanged, which
//! makes the outer integral the inner one.

use serde::{Deserialize, Serialize};

/// Reciprocity, from a sample of pairs that were integrated both ways.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reciprocity {
    /// Number of pairs of elements that were integrated both ways.
    pub pairs: usize,
    /// Largest |A_i F_ij − A_j F_ji| / min(A_i, A_j) among them.
    pub largest: f64,
}

impl Reciprocity {
    /// Counts a pair, given the difference of A_i F_ij and A_j F_ji relative to the smaller area.
    pub fn take(&mut self, difference: f64) {
        self.pairs += 1;
        self.largest = self.largest.max(difference);
    }
}
