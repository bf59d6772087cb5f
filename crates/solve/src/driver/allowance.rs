//! The time that is left to a run that ends by a deadline.

use std::time::Instant;

use radiosity_work::Work;

use super::options::Options;

/// Threads that forecasts are of.
const TOLD_OF: f64 = 2.0;

/// The time until an instant, of so many threads.
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    ends: Instant,
    threads: usize,
}

impl Allowance {
    /// The allowance of work with these options; None where nothing limits its time, and for several ranks, whose
    /// clocks differ.
    pub(super) fn of(work: &Work<'_>, options: &Options) -> Option<Self> {
        let threads = work.ranks.threads(options.threads);
        work.left().map(|left| Self::until(Instant::now() + left, threads))
    }

    /// The allowance of so many threads until an instant.
    pub(super) fn until(ends: Instant, threads: usize) -> Self {
        Self { ends, threads }
    }

    /// Seconds, by the clock.
    pub(super) fn seconds(&self) -> f64 {
        self.ends.saturating_duration_since(Instant::now()).as_secs_f64()
    }

    /// Seconds that two threads would take for what these threads do in so many seconds, as forecasts are told.
    pub(super) fn of_two(&self, seconds: f64) -> f64 {
        seconds * self.threads as f64 / TOLD_OF
    }
}
