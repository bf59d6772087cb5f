//! The pace of many things that are to be done by a deadline.
//!
//! One that begins now, while n are left that w threads do, may last until
//!
//! ```text
//! now + (end − now) w / n ,
//! ```
//!
//! so that all have their share of the time, and what some do not need goes to those after them.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// The pace of things that threads do at once, until an instant.
#[derive(Debug)]
pub struct Pace {
    ends: Instant,
    left: AtomicUsize,
    cut_short: AtomicUsize,
    threads: usize,
}

impl Pace {
    /// The pace of so many things that `threads` threads do until the instant `ends`.
    pub fn of(things: usize, threads: usize, ends: Instant) -> Self {
        Self { ends, left: things.into(), cut_short: 0.into(), threads: threads.max(1) }
    }

    /// Expects so many things, in place of those that are left.
    pub fn expect(&self, things: usize) {
        self.left.store(things, Ordering::Relaxed);
    }

    /// The instant at which a thing is to end that begins now.
    pub fn end_of_next(&self) -> Instant {
        let (now, left) = (Instant::now(), self.left().max(1));
        let share = (self.threads as f64 / left as f64).min(1.0);
        now + self.ends.saturating_duration_since(now).mul_f64(share)
    }

    /// Notes that one thing more is done.
    pub fn note_done(&self) {
        let less = |left: usize| Some(left.saturating_sub(1));
        // It is never refused.
        let _ = self.left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, less);
    }

    /// Notes that something ended because its time was up.
    pub fn note_cut_short(&self) {
        self.cut_short.fetch_add(1, Ordering::Relaxed);
    }

    /// Whether anything ended because its time was up.
    pub fn has_cut_short(&self) -> bool {
        self.cut_short.load(Ordering::Relaxed) > 0
    }

    /// Things that are left.
    pub fn left(&self) -> usize {
        self.left.load(Ordering::Relaxed)
    }

    /// The time until the end.
    pub fn time_left(&self) -> Duration {
        self.ends.saturating_duration_since(Instant::now())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_has_its_share_of_what_is_left() {
        let begun = Instant::now();
        let pace = Pace::of(10, 2, begun + Duration::from_secs(1000));
        let share = |pace: &Pace| (pace.end_of_next() - begun).as_secs_f64();
        assert!((share(&pace) - 200.0).abs() < 1.0, "{}", share(&pace));
        (0..6).for_each(|_| pace.note_done());
        assert!((share(&pace) - 500.0).abs() < 1.0, "{}", share(&pace));
        (0..9).for_each(|_| pace.note_done());
        assert!((share(&pace) - 1000.0).abs() < 1.0, "{}", share(&pace));
        let late = Pace::of(3, 1, begun);
        assert!(late.end_of_next() - begun < Duration::from_secs(1));
    }
}
