//! Counts, costs and errors of the blocks of a matrix.

use crate::blocks::block::BlockReport;
use crate::blocks::pair_counts::PairCounts;
use crate::blocks::reciprocity::Reciprocity;
use crate::blocks::remainder::Remainder;
use crate::blocks::worst_error::WorstError;

/// Counts, costs and errors of the blocks of a matrix.
#[derive(Clone, Debug, Default)]
pub struct BlockStatistics {
    /// Numbers of pairs by contact and by reason of being skipped.
    pub pairs: PairCounts,
    /// Terms of all rules; logarithms for contour integrals. Blocks that are copies count like those they
    /// were copied from.
    pub samples: u64,
    /// Kernel evaluations or logarithms: fewer than the terms where kernel values repeat.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
    /// Reciprocity, from a sample of pairs that were integrated both ways.
    pub reciprocity: Reciprocity,
    /// Estimate of the largest error of a block that rules or rays leave ([`WorstError::error`]); zero if all
    /// were resolved.
    pub accuracy_reached: f64,
    /// The block whose error is the largest multiple of what was asked of it.
    pub worst_error: Option<WorstError>,
    /// Remainders of the blocks that were not integrated.
    pub remainders: Vec<Remainder>,
}

impl BlockStatistics {
    /// Takes the error of a block into account.
    pub fn record_error(&mut self, error: WorstError) {
        self.accuracy_reached = self.accuracy_reached.max(error.error);
        if self.worst_error.is_none_or(|worst| error.excess() > worst.excess()) {
            self.worst_error = Some(error);
        }
    }

    /// Adds what it took to integrate a block.
    pub fn take_costs(&mut self, block: &BlockReport) {
        self.samples += block.samples;
        self.distinct += block.distinct;
        self.rays += block.rays;
    }
}
