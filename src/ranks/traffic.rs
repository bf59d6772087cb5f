//! What ranks send.

use std::sync::atomic::{AtomicU64, Ordering};

use serde::{Deserialize, Serialize};

/// What a rank has sent to others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Traffic {
    /// Bytes of pieces of work.
    pub pieces: u64,
    /// Bytes of numbers that products with distributed matrices complete.
    pub numbers: u64,
    /// Number of those products.
    pub products: u64,
}

/// Counts it.
#[derive(Debug, Default)]
pub(super) struct Counter {
    pieces: AtomicU64,
    numbers: AtomicU64,
    products: AtomicU64,
}

impl Counter {
    pub(super) fn count(&self, bytes: usize) {
        self.pieces.fetch_add(bytes as u64, Ordering::Relaxed);
    }

    pub(super) fn count_numbers(&self, numbers: usize) {
        self.numbers.fetch_add(8 * numbers as u64, Ordering::Relaxed);
        self.products.fetch_add(1, Ordering::Relaxed);
    }

    pub(super) fn read(&self) -> Traffic {
        let read = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
        Traffic { pieces: read(&self.pieces), numbers: read(&self.numbers), products: read(&self.products) }
    }
}
