//! How far work is, told by the threads that do it.

use std::sync::Mutex;

use radiosity::solve::Progress as Stage;

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

/// How far the threads that work are, for the one that waits.
#[derive(Debug, Default)]
pub(crate) struct Progress {
    latest: Mutex<Option<Step>>,
}

impl Progress {
    /// Says that `done` of `total` steps are done, from any thread.
    pub(crate) fn step(&self, stage: &'static str, done: usize, total: usize) {
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
}
