//! The time that is left to a run that ends by a deadline, beside forecasts of what it has yet to do.

use std::time::Instant;

use crate::work::Work;

/// Threads that forecasts are of, whatever the number that works: what follows from them is the same on any machine.
/// Chosen.
pub const FORECAST_THREADS: f64 = 2.0;

/// The time until an instant, of so many threads.
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    ends: Instant,
    threads: usize,
}

impl Allowance {
    /// The allowance of work by so many threads; None where nothing limits its time, and for several ranks, whose
    /// clocks differ.
    pub fn of(work: &Work<'_>, threads: usize) -> Option<Self> {
        work.left().map(|left| Self::until(Instant::now() + left, threads))
    }

    /// The allowance of so many threads until an instant.
    pub fn until(ends: Instant, threads: usize) -> Self {
        Self { ends, threads }
    }

    /// Seconds, by the clock.
    pub fn seconds(&self) -> f64 {
        self.ends.saturating_duration_since(Instant::now()).as_secs_f64()
    }

    /// The seconds by the clock of these threads, as a forecast tells them.
    pub fn told(&self, seconds: f64) -> f64 {
        seconds * self.threads as f64 / FORECAST_THREADS
    }

    /// Whether what is told to take so long is done in time.
    pub fn suffices(&self, told: f64) -> bool {
        told <= self.told(self.seconds())
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn more_threads_have_time_for_more() {
        let ends = Instant::now() + Duration::from_secs(1000);
        let suffices = |threads, told| Allowance::until(ends, threads).suffices(told);
        assert!(suffices(1, 450.0) && !suffices(1, 550.0) && suffices(2, 950.0) && suffices(4, 1950.0));
        let past = Allowance::until(Instant::now(), 2);
        assert!(past.suffices(0.0) && !past.suffices(1e-6));
    }
}
