//! Asking work to finish with what it has. What [`radiosity_work::interruption`] ends has no result.

use std::sync::atomic::{AtomicBool, Ordering};

/// A wish, raised by another thread, that work should finish with what it has. Only some work listens.
#[derive(Debug, Default)]
pub struct Stop {
    is_heard: AtomicBool,
    is_raised: AtomicBool,
}

/// Lasts while work listens.
#[derive(Debug)]
pub(super) struct Listening<'a>(&'a Stop);

impl Stop {
    /// Not raised yet.
    pub const fn new() -> Self {
        Self { is_heard: AtomicBool::new(false), is_raised: AtomicBool::new(false) }
    }

    /// Raises the wish. Returns whether work listens that had not heard it before.
    pub fn raise(&self) -> bool {
        self.is_heard.load(Ordering::Relaxed) && !self.is_raised.swap(true, Ordering::Relaxed)
    }

    /// Whether the wish was raised while work listened.
    pub(super) fn is_raised(&self) -> bool {
        self.is_raised.load(Ordering::Relaxed)
    }

    /// Listens from now on.
    pub(super) fn listen(&self) -> Listening<'_> {
        self.is_heard.store(true, Ordering::Relaxed);
        Listening(self)
    }
}

impl Drop for Listening<'_> {
    fn drop(&mut self) {
        self.0.is_heard.store(false, Ordering::Relaxed);
    }
}
