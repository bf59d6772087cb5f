//! The time that frames take which are not made yet.

use std::time::Instant;

/// The time of some frames.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimeLeft {
    begun: Instant,
    frames: usize,
    /// About the seconds of all.
    forecast: f64,
}

impl TimeLeft {
    /// The time of so many frames, begun at a time, that are expected to take so many seconds more.
    pub(super) fn new(begun: Instant, frames: usize, more: f64) -> Self {
        Self { begun, frames, forecast: begun.elapsed().as_secs_f64() + more }
    }

    /// About the seconds from now on when so many frames are made: by the forecast at first, by what these took later.
    pub(super) fn seconds(&self, made: usize) -> f64 {
        let spent = self.begun.elapsed().as_secs_f64();
        let part = made as f64 / self.frames as f64;
        let measured = if made > 0 { spent / part } else { self.forecast };
        let all = part.sqrt() * measured + (1.0 - part.sqrt()) * self.forecast;
        (all - spent).max(0.0)
    }
}
