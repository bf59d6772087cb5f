//! How far work is, told by the threads that do it.

use std::panic::resume_unwind;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use radiosity::solve::Progress as Stage;

/// What unwinds a thread that was asked to end. It is no panic: nothing is printed.
#[derive(Debug)]
pub(crate) struct Ended;

/// A stage of the work with what is done of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    /// Name of the stage.
    pub(crate) stage: &'static str,
    /// How much of it is done.
    pub(crate) done: u64,
    /// All of it.
    pub(crate) total: u64,
}

/// Between the threads that work and the one that waits: how far they are, and whether they are to end.
#[derive(Debug, Default)]
pub(crate) struct Progress {
    latest: Mutex<Option<Step>>,
    is_ended: AtomicBool,
}

impl Progress {
    /// Says that `done` of `total` steps are done, from any thread; does not return once the work is to end.
    pub(crate) fn step(&self, stage: &'static str, done: usize, total: usize) {
        if self.is_ended.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Ended));
        }
        // Of threads that come together one is heard.
        if let Ok(mut latest) = self.latest.try_lock() {
            *latest = Some(Step { stage, done: done as u64, total: total as u64 });
        }
    }

    /// The same of a solution in so many bands.
    pub(crate) fn stage(&self, stage: Stage, bands: usize) {
        match stage {
            Stage::Blocks(done, total) => self.step("blocks", done, total),
            Stage::Rays { done, total, .. } => self.step("rays", done as usize, total as usize),
            Stage::Estimate(done, total) => self.step("estimate", done, total),
            Stage::Solve(band, _, _) => self.step("solve", band, bands),
            Stage::Finished(..) => {}
        }
    }

    /// The latest step since the last question.
    pub(crate) fn news(&self) -> Option<Step> {
        self.latest.lock().ok()?.take()
    }

    /// From now on every thread ends at its next step.
    pub(crate) fn end(&self) {
        self.is_ended.store(true, Ordering::Relaxed);
    }
}
