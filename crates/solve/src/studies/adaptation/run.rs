//! The loop of an adaptation: solve, estimate, refine, until the error is small enough.

use std::time::{Duration, Instant};

use radiosity_elements::mesh::Mesh;
use radiosity_scene::Scene;
use radiosity_solvers::{SolveError, Stop};
use radiosity_work::{Progress, Stage, Work};

use super::error_estimate::ErrorEstimate;
use super::estimate::estimate;
use crate::driver::{Failure, MemoryReduction, Options, Outcome, solve, solve_exactly, timed};
use crate::goal::{Achieved, Aim, EndReason, Goal};
use crate::solved::Solved;

/// Order of the first runs by exact blocks: the lowest whose error a finer one tells, and whose solution
/// takes next to no time.
pub(super) const FIRST_ORDER: usize = 2;

/// An adaptation of solutions to a goal.
pub(super) struct Adaptation<'a> {
    pub goal: &'a Goal,
    pub work: &'a Work<'a>,
    /// Why exact blocks carry the pairs, where the adaptation decides that.
    pub why: Option<&'a str>,
}

/// A run that is to be made.
pub(super) struct PlannedRun {
    pub options: Options,
    /// The cells of surfaces, if they are refined.
    pub mesh: Option<Mesh>,
    /// Error that it is expected to have; its light is gathered as that needs it.
    pub expected: f64,
    /// About its time over that of the run before.
    pub growth: f64,
}

/// The run after another, or the reason why there is none.
pub(super) type NextRun = Result<PlannedRun, EndReason>;

impl Adaptation<'_> {
    /// The first run of an adaptation.
    pub(super) fn first(&self, options: Options) -> PlannedRun {
        PlannedRun { options, mesh: None, expected: self.goal.accuracy, growth: 1.0 }
    }

    /// Solves `scene` by `planned`, then by what `next` makes of every run and its estimate.
    pub(super) fn refined(
        &self,
        scene: Scene,
        mut planned: PlannedRun,
        mut next: impl FnMut(&Solved, &ErrorEstimate) -> Result<NextRun, Failure>,
    ) -> Result<Solved, Failure> {
        let mut begun = Instant::now();
        let outcome = self.solve(&scene, &planned).map_err(advise)?;
        let mut run = Solved::of(scene, planned.options, outcome, None);
        loop {
            let found = self.found(&mut run, planned.expected)?;
            let following = match found.error {
                _ if !run.outcome.converged => Err(EndReason::NotConverged),
                Some(error) if error <= self.goal.accuracy => Err(EndReason::Reached),
                _ => next(&run, &found)?,
            };
            let finer = match following {
                Ok(next) if !self.work.fits(begun.elapsed().mul_f64(next.growth)) => Err(EndReason::Time),
                Ok(next) => {
                    (begun, planned) = (Instant::now(), next);
                    self.finer(&run, &planned)?
                }
                Err(end) => Err(end),
            };
            match finer {
                Ok(outcome) => run = Solved::of(run.scene, planned.options, outcome, None),
                Err(end) => {
                    run.achieved = Some(Achieved::new(self.goal, found.error, end));
                    return Ok(run);
                }
            }
        }
    }

    fn solve(&self, scene: &Scene, planned: &PlannedRun) -> Result<Outcome, Failure> {
        match self.why {
            None => solve(scene, &planned.options, self.work),
            Some(why) => solve_exactly(scene, &planned.options, why, planned.mesh.as_ref(), self.work),
        }
    }

    /// The estimated error of a run that is expected to have about the error `expected`; once more where
    /// light that was gathered for a larger error may hide as much as is wanted.
    fn found(&self, run: &mut Solved, expected: f64) -> Result<ErrorEstimate, Failure> {
        if let (Aim::Solution, Some(sampling)) = (self.goal.of, run.outcome.sampling) {
            return Ok(ErrorEstimate { error: sampling.error, shares: Vec::new() });
        }
        if !run.outcome.converged {
            return Ok(ErrorEstimate { error: None, shares: Vec::new() });
        }
        let wanted = self.goal.accuracy;
        let found = self.estimated(run, expected)?;
        let is_doubtful = expected > wanted && found.error.is_some_and(|error| error <= wanted);
        if is_doubtful { self.estimated(run, wanted) } else { Ok(found) }
    }

    /// The estimated error of a run, timed.
    fn estimated(&self, run: &mut Solved, expected: f64) -> Result<ErrorEstimate, Failure> {
        let mut taken = Duration::ZERO;
        let estimate = timed(&mut taken, || estimate(run, self.goal, expected, self.work))?;
        run.outcome.seconds.estimate = taken;
        self.work.report(Progress::Finished { stage: Stage::Estimate, took: taken });
        Ok(estimate)
    }

    /// The outcome of the run after `before`, or the reason why it ends the sequence.
    fn finer(&self, before: &Solved, next: &PlannedRun) -> Result<Result<Outcome, EndReason>, Failure> {
        match self.solve(&before.scene, next) {
            Ok(outcome) if !outcome.converged => Ok(Err(EndReason::NotConverged)),
            Ok(outcome) if sends_no_more(&outcome, &before.outcome) => Ok(Err(self.stopped())),
            Ok(outcome) => Ok(Ok(outcome)),
            Err(Failure::Solver { source: SolveError::NotConverged { stop: Stop::Time, .. }, .. }) => {
                Ok(Err(EndReason::Time))
            }
            Err(Failure::Solver { source: SolveError::NotConverged { .. }, .. }) => {
                Ok(Err(EndReason::NotConverged))
            }
            Err(Failure::Memory { .. }) => Ok(Err(EndReason::Memory)),
            Err(failure) => Err(failure),
        }
    }

    /// The reason why rays were stopped.
    pub(super) fn stopped(&self) -> EndReason {
        if self.work.is_late() { EndReason::Time } else { EndReason::Stopped }
    }

    /// About the time of a run by exact blocks with so many unknowns over that of the run before; the reason
    /// why there is none where these are more than allowed.
    pub(super) fn growth(&self, before: &Solved, unknowns: usize) -> Result<f64, EndReason> {
        let growth = unknowns as f64 / before.outcome.solution.elements().coefficients() as f64;
        if unknowns > self.goal.most_unknowns { Err(EndReason::Unknowns) } else { Ok(growth.powi(2)) }
    }
}

/// Whether rays that carried the pairs of `finer` were stopped before they were more than `before`.
fn sends_no_more(finer: &Outcome, before: &Outcome) -> bool {
    finer.sampling.zip(before.sampling).is_some_and(|(finer, before)| finer.rays <= before.rays)
}

/// Adds that lower orders than that of the first run are possible only without a wanted accuracy.
fn advise(failure: Failure) -> Failure {
    let Failure::Memory { needed, allowed, fits } = failure else { return failure };
    let fit = |fit| match fit {
        MemoryReduction::Order(order) if order < FIRST_ORDER => MemoryReduction::OrderAlone(order),
        fit => fit,
    };
    Failure::Memory { needed, allowed, fits: fits.into_iter().map(fit).collect() }
}
