//! When a factorisation must end before it is done.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crate::error::{SolveError, Stop};
use crate::settings::Settings;

/// The flag and the time budget of a caller, asked between the steps of a direct method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Halt<'a> {
    method: &'static str,
    cancel: Option<&'a AtomicBool>,
    time_budget: Option<Duration>,
    started: Instant,
    tolerance: f64,
}

impl<'a> Halt<'a> {
    /// The wishes in `settings`; the time budget begins at `started`.
    pub(crate) fn new(method: &'static str, settings: &Settings<'a>, started: Instant) -> Self {
        let Settings { cancel, time_budget, tolerance, .. } = *settings;
        Self { method, cancel, time_budget, started, tolerance }
    }

    /// Refuses to go on once the flag is raised or the time is used up; `residual` is reached after
    /// `iterations`.
    ///
    /// # Errors
    /// [`SolveError::Cancelled`], or [`SolveError::NotConverged`] for [`Stop::Time`].
    pub(crate) fn check(&self, iterations: usize, residual: f64) -> Result<(), SolveError> {
        if self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return Err(SolveError::Cancelled { iterations, residual });
        }
        if self.time_budget.is_some_and(|budget| self.started.elapsed() >= budget) {
            let Self { method, tolerance, .. } = *self;
            return Err(SolveError::NotConverged {
                method,
                iterations,
                residual,
                tolerance,
                stop: Stop::Time,
            });
        }
        Ok(())
    }

    /// [`check`](Self::check) before any residual is known.
    ///
    /// # Errors
    /// Errors of [`check`](Self::check).
    pub(crate) fn check_factoring(&self) -> Result<(), SolveError> {
        self.check(0, f64::INFINITY)
    }
}
