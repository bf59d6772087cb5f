//! Deadlines, at which work ends with the best that it has. What an [interruption](crate::interruption) ends
//! has no result.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// The end of work with the best that it has: at an instant, or once a person wishes it.
///
/// Rays are sent no further, solvers give up, and no finer run begins. The wish ends rays alone: it is heard
/// while they are sent.
#[derive(Debug, Default)]
pub struct Deadline {
    at: Option<Instant>,
    is_heard: AtomicBool,
    is_wished: AtomicBool,
}

/// A guard that lasts while work listens to wishes.
#[derive(Debug)]
#[must_use = "work listens until it is dropped"]
pub struct Listening<'a>(&'a Deadline);

impl Deadline {
    /// A deadline at this instant; None for the wish alone.
    pub const fn at(at: Option<Instant>) -> Self {
        Self { at, is_heard: AtomicBool::new(false), is_wished: AtomicBool::new(false) }
    }

    /// Wishes that the work ends. Returns whether work listens that had not heard it before.
    pub fn wish(&self) -> bool {
        self.is_heard.load(Ordering::Relaxed) && !self.is_wished.swap(true, Ordering::Relaxed)
    }

    /// Whether the end of the work was wished while it listened.
    pub(crate) fn is_wished(&self) -> bool {
        self.is_wished.load(Ordering::Relaxed)
    }

    /// Whether the instant has passed.
    pub(crate) fn is_past(&self) -> bool {
        self.at.is_some_and(|at| Instant::now() >= at)
    }

    /// The time until the instant; None without one.
    pub(crate) fn left(&self) -> Option<Duration> {
        Some(self.at?.saturating_duration_since(Instant::now()))
    }

    /// Listens from now on.
    pub fn listen(&self) -> Listening<'_> {
        self.is_heard.store(true, Ordering::Relaxed);
        Listening(self)
    }
}

impl Drop for Listening<'_> {
    fn drop(&mut self) {
        self.0.is_heard.store(false, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wish_is_heard_once_and_while_work_listens() {
        let deadline = Deadline::default();
        assert!(!deadline.wish() && !deadline.is_wished());
        let listening = deadline.listen();
        assert!(deadline.wish() && deadline.is_wished());
        assert!(!deadline.wish(), "it was heard before");
        drop(listening);
        assert!(!deadline.wish() && deadline.is_wished());
        assert_eq!((deadline.is_past(), deadline.left()), (false, None));
    }

    #[test]
    fn an_instant_passes() {
        let now = Instant::now();
        let past = Deadline::at(Some(now));
        assert_eq!((past.is_past(), past.left()), (true, Some(Duration::ZERO)));
        let ahead = Deadline::at(Some(now + Duration::from_secs(1000)));
        assert!(!ahead.is_past() && ahead.left().is_some_and(|left| left > Duration::from_secs(900)));
    }
}
