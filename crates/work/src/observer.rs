//! Observers, who hear how far work is.

use crate::progress::Progress;

/// Hears how far work is, from any thread; functions of a [`Progress`] do.
pub trait Observer: Sync {
    /// Takes note of what is done.
    fn hear(&self, progress: Progress);
}

impl<F: Fn(Progress) + Sync> Observer for F {
    fn hear(&self, progress: Progress) {
        self(progress);
    }
}

/// Takes note of nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Silent;

impl Observer for Silent {
    fn hear(&self, _: Progress) {}
}
