//! Deadlines, at which work ends with the best that it has. What an [interruption](crate::interruption) ends
//! has no result.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// The end of work with the best that it has: at an instant, or once a person wishes it.
///
/// Rays are sent no further, solvers give up, and no finer run begins. The wish ends rays alone: it is
/// accepted while they are sent.
#[derive(Debug, Default)]
pub struct Deadline {
    at: Option<Instant>,
    accepts_wishes: AtomicBool,
    is_wished: AtomicBool,
}

/// A guard that lasts while work accepts wishes.
#[derive(Debug)]
#[must_use = "wishes are accepted until it is dropped"]
pub struct WishGuard<'a>(&'a Deadline);

impl Deadline {
    /// A deadline at this instant; None for the wish alone.
    pub const fn at(at: Option<Instant>) -> Self {
        Self { at, accepts_wishes: AtomicBool::new(false), is_wished: AtomicBool::new(false) }
    }

    /// Whether it is an instant, not the wish alone.
    pub fn has_instant(&self) -> bool {
        self.at.is_some()
    }

    /// Wishes that the work ends. Returns whether this is the first wish that is accepted.
    pub fn wish(&self) -> bool {
        self.accepts_wishes.load(Ordering::Relaxed) && !self.is_wished.swap(true, Ordering::Relaxed)
    }

    /// Whether the end of the work was wished while wishes were accepted.
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

    /// Accepts wishes until the guard is dropped.
    pub fn accept_wishes(&self) -> WishGuard<'_> {
        self.accepts_wishes.store(true, Ordering::Relaxed);
        WishGuard(self)
    }
}

impl Drop for WishGuard<'_> {
    fn drop(&mut self) {
        self.0.accepts_wishes.store(false, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wish_is_accepted_once_and_while_wishes_are() {
        let deadline = Deadline::default();
        assert!(!deadline.wish() && !deadline.is_wished());
        let guard = deadline.accept_wishes();
        assert!(deadline.wish() && deadline.is_wished());
        assert!(!deadline.wish(), "it was accepted before");
        drop(guard);
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
