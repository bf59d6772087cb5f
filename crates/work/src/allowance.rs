//! The time that is left to a run that ends by a deadline, beside forecasts of what it has yet to do.

use std::time::Instant;

use crate::machine::Machine;
use crate::work::Work;

/// The time until an instant, of so many threads.
#[derive(Clone, Copy, Debug)]
pub struct Allowance {
    ends: Instant,
    machine: Machine,
}

impl Allowance {
    /// The allowance of work by so many threads; None where nothing limits its time, and for several ranks, whose
    /// clocks differ.
    pub fn of(work: &Work<'_>, threads: usize) -> Option<Self> {
        work.left().map(|left| Self::until(Instant::now() + left, threads))
    }

    /// The allowance of so many threads until an instant.
    pub fn until(ends: Instant, threads: usize) -> Self {
        Self { ends, machine: Machine::of(threads) }
    }

    /// Seconds, by the clock.
    pub fn seconds(&self) -> f64 {
        self.ends.saturating_duration_since(Instant::now()).as_secs_f64()
    }

    /// The forecast of what these threads do in so many seconds by the clock.
    pub fn forecast(&self, seconds: f64) -> f64 {
        self.machine.forecast(seconds)
    }

    /// Whether what has this forecast is done in time.
    pub fn suffices(&self, forecast: f64) -> bool {
        forecast <= self.forecast(self.seconds())
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn more_threads_have_time_for_more() {
        let ends = Instant::now() + Duration::from_secs(1000);
        let suffices = |threads, forecast| {
            Allowance { ends, machine: Machine { threads, slowness: 1.0 } }.suffices(forecast)
        };
        assert!(suffices(1, 450.0) && !suffices(1, 550.0) && suffices(2, 950.0) && suffices(4, 1950.0));
        let past = Allowance::until(Instant::now(), 2);
        assert!(past.suffices(0.0) && !past.suffices(1e-6));
    }
}
