//! The loop around all iterative methods: budgets, observer, and a recomputed residual at the end.
//!
//! A method says how it advances and what it estimates its residual to be. Before success is reported the
//! residual is recomputed from A, b and x; if the estimate was too low the method restarts from there. An
//! iteration is stuck when its residual has set no new record for one and a half times `patience` and does
//! not fall on average either: after the first half of a patience, in which residuals may rise, each half
//! must sum to less than the one before. At the rounding floor neither holds, so that every tolerance ends,
//! even 0.

use std::sync::atomic::Ordering;
use std::time::Instant;

use crate::error::{SolveError, Stop};
use crate::problem::{Problem, exploded};
use crate::settings::Settings;
use crate::solver::{Report, Step};
use crate::vector::all_finite;

/// Growth of the residual after which an iteration is given up. That of conjugate gradients may rise before
/// it falls, by less than this in matrices that double precision can solve.
const DIVERGED: f64 = 1e12;

/// Estimates in a row that were too low, without a new record of the recomputed residual, after which a
/// method is stuck: one or two may come of rounding. With a larger value a method that gains no more takes
/// longer to say so.
const CLAIMS: usize = 5;

/// The iteration of one method.
pub(crate) trait Iteration {
    /// Brings `x` up to date, recomputes its relative residual and goes on from there.
    fn renew(&mut self, x: &mut [f64]) -> Result<f64, SolveError>;

    /// Advances by one iteration; returns the method's estimate of the relative residual.
    fn advance(&mut self, x: &mut [f64]) -> Result<f64, SolveError>;

    /// Matrix entries multiplied, divided by dim².
    fn work(&self) -> f64;

    /// Different block columns used.
    fn columns(&self) -> usize;

    /// b − A x, where the method keeps it as what is still to be shot.
    fn unshot(&self) -> Option<&[f64]> {
        None
    }
}

/// Limits of an iteration, and the name of its method.
pub(crate) struct Watch {
    pub(crate) method: &'static str,
    /// Most iterations.
    pub(crate) limit: usize,
    /// Iterations that are asked for: after these the last x counts, not the best one.
    pub(crate) asked: Option<usize>,
    /// Iterations without a new record after which the method may be stuck.
    pub(crate) patience: usize,
    /// Iterations between two checks whether `x` should be kept.
    pub(crate) keep_every: usize,
}

/// Why the loop was left without success.
enum End {
    Stopped(Stop),
    Cancelled,
    Failed(SolveError),
}

impl From<SolveError> for End {
    fn from(error: SolveError) -> Self {
        Self::Failed(error)
    }
}

impl From<Stop> for End {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}

/// The state of the loop.
struct Run<'r> {
    watch: &'r Watch,
    settings: &'r Settings<'r>,
    observer: &'r mut dyn FnMut(&Step<'_>),
    start: Instant,
    /// The estimated residuals, from before the first iteration on.
    history: Vec<f64>,
    /// Iteration of the lowest entry of `history`.
    record: usize,
    /// The best x kept, its estimated residual and its iteration.
    best: Vec<f64>,
    best_residual: f64,
    best_iteration: usize,
}

/// Runs `iteration` from `x` until its recomputed residual is at most the tolerance, or something ends it.
pub(crate) fn iterate(
    problem: &Problem<'_>,
    watch: &Watch,
    iteration: &mut dyn Iteration,
    x: &mut [f64],
    settings: &Settings<'_>,
    observer: &mut dyn FnMut(&Step<'_>),
) -> Result<Report, SolveError> {
    if !all_finite(x) {
        return Err(SolveError::NonFinite { what: "the first guess" });
    }
    let mut run = Run {
        watch,
        settings,
        observer,
        start: Instant::now(),
        history: Vec::new(),
        record: 0,
        best: x.to_vec(),
        best_residual: f64::INFINITY,
        best_iteration: 0,
    };
    if problem.norm == 0.0 {
        x.fill(0.0);
        run.history.push(0.0);
        return Ok(run.report(iteration, 0.0));
    }
    match run.reach_tolerance(iteration, x) {
        Ok(residual) => Ok(run.report(iteration, residual)),
        Err(end) => run.give_up(iteration, x, end),
    }
}

impl Run<'_> {
    /// Iterates; returns the recomputed residual once it is at most the tolerance.
    fn reach_tolerance(&mut self, iteration: &mut dyn Iteration, x: &mut [f64]) -> Result<f64, End> {
        let mut residual = iteration.renew(x)?;
        self.note(iteration, x, residual);
        let mut proven = residual;
        let mut claims = 0;
        while proven > self.settings.tolerance {
            if residual <= self.settings.tolerance {
                residual = iteration.renew(x)?;
                claims = if residual < proven { 0 } else { claims + 1 };
                proven = proven.min(residual);
                if claims == CLAIMS {
                    return Err(Stop::Stagnation.into());
                }
                continue;
            }
            self.may_go_on(residual)?;
            residual = iteration.advance(x)?;
            self.note(iteration, x, residual);
        }
        Ok(proven)
    }

    fn done(&self) -> usize {
        self.history.len().saturating_sub(1)
    }

    /// Appends the residual of one more iteration and calls the observer.
    fn note(&mut self, iteration: &dyn Iteration, x: &[f64], residual: f64) {
        self.history.push(residual);
        let done = self.done();
        if residual < self.history[self.record] {
            self.record = done;
        }
        let due = done == 0 || done - self.best_iteration >= self.watch.keep_every;
        if due && residual < self.best_residual {
            self.best.copy_from_slice(x);
            self.best_residual = residual;
            self.best_iteration = done;
        }
        (self.observer)(&Step {
            iteration: done,
            residual,
            work: iteration.work(),
            unshot: iteration.unshot(),
            x,
        });
    }

    /// Whether nothing forbids another iteration.
    fn may_go_on(&self, residual: f64) -> Result<(), End> {
        if self.settings.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return Err(End::Cancelled);
        }
        if self.settings.time_budget.is_some_and(|budget| self.start.elapsed() >= budget) {
            return Err(Stop::Time.into());
        }
        if self.watch.asked.is_some_and(|asked| self.done() >= asked) {
            return Err(Stop::Shots.into());
        }
        if residual > DIVERGED * self.history[0] || !residual.is_finite() {
            return Err(Stop::Divergence.into());
        }
        if self.stuck() {
            return Err(Stop::Stagnation.into());
        }
        if self.done() >= self.watch.limit {
            return Err(Stop::Iterations.into());
        }
        Ok(())
    }

    /// Whether neither the record nor the sums over half a patience fall; called once after each iteration.
    fn stuck(&self) -> bool {
        let half = self.watch.patience / 2;
        let since = &self.history[self.record + 1..];
        if since.len() < 3 * half || !since.len().is_multiple_of(half) {
            return false;
        }
        let (before, last) = since[since.len() - 2 * half..].split_at(half);
        last.iter().sum::<f64>() >= before.iter().sum()
    }

    /// Leaves the best iterate in `x`, with its recomputed residual.
    fn give_up(self, iteration: &mut dyn Iteration, x: &mut [f64], end: End) -> Result<Report, SolveError> {
        let exploded = exploded(x);
        let residual = match end {
            End::Stopped(Stop::Shots) => iteration.renew(x)?,
            _ => self.settle(iteration, x),
        };
        let stop = match end {
            End::Stopped(stop) => stop,
            End::Failed(SolveError::NonFinite { .. }) if exploded => Stop::Divergence,
            End::Failed(error) => return Err(error),
            End::Cancelled => return Err(SolveError::Cancelled { iterations: self.done(), residual }),
        };
        if residual <= self.settings.tolerance {
            return Ok(self.report(iteration, residual));
        }
        Err(SolveError::NotConverged {
            method: self.watch.method,
            iterations: self.done(),
            residual,
            tolerance: self.settings.tolerance,
            stop,
        })
    }

    /// Chooses between the last iterate and the best one kept; returns the recomputed residual of the choice.
    fn settle(&self, iteration: &mut dyn Iteration, x: &mut [f64]) -> f64 {
        let last = iteration.renew(x).unwrap_or(f64::INFINITY);
        if last <= self.best_residual && last.is_finite() {
            return last;
        }
        let last_x = x.to_vec();
        x.copy_from_slice(&self.best);
        let kept = iteration.renew(x).unwrap_or(f64::INFINITY);
        if last < kept {
            x.copy_from_slice(&last_x);
        }
        last.min(kept)
    }

    /// The report of a success.
    fn report(self, iteration: &dyn Iteration, residual: f64) -> Report {
        Report {
            method: self.watch.method,
            iterations: self.done(),
            residual,
            history: self.history,
            work: iteration.work(),
            columns: iteration.columns(),
            condition: None,
        }
    }
}
