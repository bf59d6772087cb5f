//! Progress of work, reported by the threads that do it.

use std::sync::Mutex;

use radiosity::work::{Observer, Progress as Event, Stage};

/// A stage of the work with what is done of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Step {
    /// Name of the stage.
    pub(crate) stage: &'static str,
    /// Number of steps that are done.
    pub(crate) done: u64,
    /// Number of steps in all.
    pub(crate) total: u64,
}

/// Progress of the threads that work, for the thread that waits.
#[derive(Debug, Default)]
pub(crate) struct Progress {
    latest: Mutex<Option<Step>>,
}

impl Progress {
    /// Says that `done` of `total` steps are done, from any thread.
    pub(crate) fn step(&self, stage: &'static str, done: usize, total: usize) {
        // Of threads that come together one counts.
        if let Ok(mut latest) = self.latest.try_lock() {
            *latest = Some(Step { stage, done: done as u64, total: total as u64 });
        }
    }

    /// The latest step since the last call; none if there is none.
    pub(crate) fn news(&self) -> Option<Step> {
        self.latest.lock().ok()?.take()
    }
}

impl Observer for Progress {
    fn report(&self, event: Event) {
        match event {
            Event::Done { stage, done, of } => self.step(stage.name(), done, of),
            Event::Rays { done, of, .. } => self.step("rays", done as usize, of as usize),
            Event::Iteration { band, of, .. } => self.step(Stage::Solve.name(), band, of),
            Event::Expected { .. } | Event::Began { .. } | Event::Ended { .. } => {}
        }
    }
}
