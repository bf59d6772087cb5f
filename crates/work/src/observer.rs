//! Observers, to whom work reports how far it is.

use crate::progress::Progress;

/// Takes reports of the progress of work, from any thread; functions of a [`Progress`] do.
pub trait Observer: Sync {
    /// Takes a report of what is done.
    fn report(&self, progress: Progress);
}

impl<F: Fn(Progress) + Sync> Observer for F {
    fn report(&self, progress: Progress) {
        self(progress);
    }
}

/// Drops all reports.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Silent;

impl Observer for Silent {
    fn report(&self, _: Progress) {}
}
