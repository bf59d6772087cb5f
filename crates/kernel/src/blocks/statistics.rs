//! Counts, costs and errors of the blocks of a matrix.

use crate::blocks::block::BlockReport;
use crate::blocks::pair_counts::PairCounts;
use crate::blocks::remainder::Remainder;
use crate::blocks::row_error::RowError;
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
    /// Estimate of the largest error of a block that rules or rays leave ([`WorstError::error`]); zero if all
    /// were resolved.
    pub accuracy_reached: f64,
    /// The block whose error is the largest multiple of what was asked of it.
    pub worst_error: Option<WorstError>,
    /// Errors of what each element exchanges, by elements; none where all are exact.
    pub row_errors: Vec<RowError>,
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

    /// Takes the error of what two of so many elements exchange: what is known of it and what was asked of it
    /// (length²).
    pub fn take_exchange(&mut self, pair: [usize; 2], elements: usize, known: f64, asked: f64) {
        if known == 0.0 && asked == 0.0 {
            return;
        }
        self.row_errors.resize(elements, RowError::default());
        self.row_errors[pair[0]].take(known, asked);
        if pair[0] != pair[1] {
            self.row_errors[pair[1]].take(known, asked);
        }
    }

    /// Adds what it took to integrate a block.
    pub fn take_costs(&mut self, block: &BlockReport) {
        self.samples += block.samples;
        self.distinct += block.distinct;
        self.rays += block.rays;
    }
}
