//! Counts of what ranks do and send.

use std::sync::atomic::{AtomicU64, Ordering};

use serde::{Deserialize, Serialize};

/// Work that a rank has done for all, and bytes that it sent to others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Traffic {
    /// Terms of the kernel's quadrature rules.
    pub samples: u64,
    /// Rays that carried pairs of elements, and segments tested for visibility.
    pub rays: u64,
    /// Bytes of pieces of work.
    pub pieces: u64,
    /// Bytes of numbers that products with distributed matrices complete.
    pub numbers: u64,
    /// Number of these products.
    pub products: u64,
}

/// Counters of the work and the traffic of a rank.
#[derive(Debug, Default)]
pub(super) struct Counter {
    samples: AtomicU64,
    rays: AtomicU64,
    pieces: AtomicU64,
    numbers: AtomicU64,
    products: AtomicU64,
}

impl Counter {
    pub(super) fn count_work(&self, samples: u64, rays: u64) {
        self.samples.fetch_add(samples, Ordering::Relaxed);
        self.rays.fetch_add(rays, Ordering::Relaxed);
    }

    pub(super) fn count(&self, bytes: usize) {
        self.pieces.fetch_add(bytes as u64, Ordering::Relaxed);
    }

    pub(super) fn count_numbers(&self, numbers: usize) {
        self.numbers.fetch_add(8 * numbers as u64, Ordering::Relaxed);
        self.products.fetch_add(1, Ordering::Relaxed);
    }

    pub(super) fn read(&self) -> Traffic {
        let read = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
        Traffic {
            samples: read(&self.samples),
            rays: read(&self.rays),
            pieces: read(&self.pieces),
            numbers: read(&self.numbers),
            products: read(&self.products),
        }
    }
}
