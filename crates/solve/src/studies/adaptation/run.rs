//! Runs of an adaptation: whether another fits, what ended it, and what its error is.

use std::time::Duration;

use radiosity_scene::Scene;
use radiosity_solvers::{SolveError, Stop};
use radiosity_work::{Progress, Stage, Work};

use crate::driver::{Failure, MemoryReduction, Options, Outcome, timed};

use super::achieved::EndReason;
use super::error_estimate::ErrorEstimate;
use super::estimate::estimate;
use super::goal::Goal;

/// Order of the first rungs: the lowest whose error a finer one tells, and whose solution takes next to no
/// time.
pub(super) const FIRST_ORDER: usize = 2;

/// The estimated error of a run that is expected to have about the error `expected`, timed.
pub(super) fn estimated(
    scene: &Scene,
    outcome: &mut Outcome,
    options: &Options,
    goal: &Goal,
    expected: f64,
    work: &Work<'_>,
) -> Result<ErrorEstimate, Failure> {
    let mut taken = Duration::ZERO;
    let estimate = timed(&mut taken, || estimate(scene, outcome, options, goal, expected, work))?;
    outcome.seconds.estimate = taken;
    work.report(Progress::Finished { stage: Stage::Estimate, took: taken });
    Ok(estimate)
}

/// A run after the first, or the reason why it ends the sequence.
pub(super) fn finer(run: Result<Outcome, Failure>) -> Result<Result<Outcome, EndReason>, Failure> {
    match run {
        Ok(outcome) if outcome.converged => Ok(Ok(outcome)),
        Err(Failure::Solver { source: SolveError::NotConverged { stop: Stop::Time, .. }, .. }) => {
            Ok(Err(EndReason::Time))
        }
        Ok(_) | Err(Failure::Solver { source: SolveError::NotConverged { .. }, .. }) => {
            Ok(Err(EndReason::NotConverged))
        }
        Err(Failure::Memory { .. }) => Ok(Err(EndReason::Memory)),
        Err(failure) => Err(failure),
    }
}

/// Adds that lower orders than that of the first run are possible only without a wanted accuracy.
pub(super) fn advise(failure: Failure) -> Failure {
    let Failure::Memory { needed, allowed, fits } = failure else { return failure };
    let fit = |fit| match fit {
        MemoryReduction::Order(order) if order < FIRST_ORDER => MemoryReduction::OrderAlone(order),
        fit => fit,
    };
    Failure::Memory { needed, allowed, fits: fits.into_iter().map(fit).collect() }
}
