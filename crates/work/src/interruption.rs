//! Interruption: another thread ends work of which nothing is wanted any more.
//!
//! Work runs within an interruption ([`Interruption::within`]) as it runs within a pool of threads. Whatever
//! takes long asks between small pieces of it (a row of pairs, a part of a pair, some hundred rays) whether
//! the interruption was raised; if so the thread unwinds, as it does for a panic but without its message, up
//! to `within`, which returns [`Interrupted`]. Nothing of the work is kept, and whatever it has borrowed is
//! as it was: the same may be computed again.
//!
//! ```
//! use radiosity_work::interruption::{Interrupted, Interruption, check_interrupt};
//! use std::thread;
//! use std::time::Duration;
//!
//! let interruption = Interruption::new();
//! let found = thread::scope(|scope| {
//!     // Any thread may raise it: one that waits for a key or a deadline, or a handler of signals.
//!     scope.spawn(|| {
//!         thread::sleep(Duration::from_millis(50));
//!         interruption.raise();
//!     });
//!     interruption.within(|| -> () { loop { check_interrupt() } })
//! });
//! assert!(matches!(found, Err(Interrupted)));
//! ```
//!
//! Threads of the pools that the library makes (`in_threads`) check the interruption of the thread that made
//! them; those of other pools check none, or that of a piece of work that they take over while they wait. So
//! functions that take no number of threads, such as those that read a solution, are to be called through
//! `in_threads`. A program built with `panic = "abort"` ends instead.
//!
//! A [`Deadline`](crate::Deadline) is something else: there work ends with the best that it has, which is
//! then of use. [Ranks](crate::ranks) wait for each other: those that share work are to be ended as
//! processes.

use std::cell::RefCell;
use std::error::Error;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

thread_local! {
    /// The interruption that this thread checks.
    static CURRENT: RefCell<Option<Interruption>> = const { RefCell::new(None) };
}

/// Ends the work within it once it is raised; clones are the same interruption.
#[derive(Clone, Debug, Default)]
pub struct Interruption {
    is_raised: Arc<AtomicBool>,
}

/// The work was interrupted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interrupted;

impl fmt::Display for Interrupted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the work was interrupted")
    }
}

impl Error for Interrupted {}

/// Payload with which a thread that was interrupted unwinds: the interruption that was raised.
#[derive(Debug)]
struct Ended(Interruption);

/// Sets back the interruption that a thread checks, whatever happens.
struct RestorePrevious(Option<Interruption>);

impl Drop for RestorePrevious {
    fn drop(&mut self) {
        CURRENT.set(self.0.take());
    }
}

impl Interruption {
    /// Not raised yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Ends the work within it, now and whenever some begins; returns at once.
    pub fn raise(&self) {
        self.is_raised.store(true, Ordering::Relaxed);
    }

    /// Whether the interruption was raised.
    fn is_raised(&self) -> bool {
        self.is_raised.load(Ordering::Relaxed)
    }

    /// The flag that raising sets, for solvers, which stop where it is set.
    pub fn flag(&self) -> &AtomicBool {
        &self.is_raised
    }

    /// Does `work`, which checks this interruption and no other around it.
    ///
    /// # Errors
    /// [`Interrupted`] where it was raised before the work was done.
    pub fn within<T>(&self, work: impl FnOnce() -> T) -> Result<T, Interrupted> {
        let _restore = RestorePrevious(CURRENT.replace(Some(self.clone())));
        let work = || {
            check_interrupt();
            work()
        };
        // The library leaves nothing half changed that outlives its work.
        let done = catch_unwind(AssertUnwindSafe(work));
        done.map_err(|fault| match fault.downcast_ref() {
            Some(Ended(raised)) if Arc::ptr_eq(&raised.is_raised, &self.is_raised) => Interrupted,
            _ => resume_unwind(fault),
        })
    }
}

/// The interruption that the current thread checks.
pub fn current() -> Option<Interruption> {
    CURRENT.with_borrow(Clone::clone)
}

/// Lets the current thread check this interruption from now on.
pub fn set_current(interruption: Option<Interruption>) {
    CURRENT.set(interruption);
}

/// Does not return where the work of this thread is to end. It takes some nanoseconds: once for each part of
/// the work that takes microseconds.
#[inline]
pub fn check_interrupt() {
    if CURRENT.with_borrow(|current| current.as_ref().is_some_and(Interruption::is_raised)) {
        end();
    }
}

/// Unwinds this thread, whose interruption was raised.
#[cold]
fn end() {
    if let Some(raised) = current() {
        resume_unwind(Box::new(Ended(raised)));
    }
}

/// Rays of which one asks: each takes a part of a microsecond.
const RAYS: u64 = 64;

/// Ends the work if it is interrupted, as [`check_interrupt`], before the ray or sample of this number.
#[inline]
pub fn check_interrupt_at(number: u64) {
    if number.is_multiple_of(RAYS) {
        check_interrupt();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_innermost_is_checked_and_clones_are_one() {
        let [outer, inner] = [Interruption::new(), Interruption::new()];
        outer.clone().raise();
        let found = inner.within(|| outer.within(|| 1));
        assert_eq!(found, Ok(Err(Interrupted)));
        assert_eq!(outer.within(|| 1), Err(Interrupted));
        assert_eq!(inner.within(|| 1), Ok(1));
        // The thread checks none any more.
        assert!(current().is_none());
        check_interrupt();
    }

    #[test]
    fn an_outer_one_passes_an_inner_one() {
        let [outer, inner] = [Interruption::new(), Interruption::new()];
        let found = outer.within(|| {
            let ended = || {
                outer.raise();
                set_current(Some(outer.clone()));
                check_interrupt();
            };
            inner.within(ended)
        });
        assert_eq!(found, Err(Interrupted));
    }

    #[test]
    fn panics_pass() {
        let found = catch_unwind(|| Interruption::new().within(|| resume_unwind(Box::new("fault"))));
        let fault = found.map(|_: Result<(), Interrupted>| ()).expect_err("it passes");
        assert_eq!(fault.downcast_ref::<&str>(), Some(&"fault"));
    }
}
