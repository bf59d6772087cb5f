//! The loop of an adaptation: solve, estimate, refine, until the error is small enough.

use std::cell::OnceCell;
use std::time::{Duration, Instant};

use radiosity_audit::Verdict;
use radiosity_elements::mesh::Mesh;
use radiosity_scene::Scene;
use radiosity_solvers::{SolveError, Stop};
use radiosity_work::{Stage, Work};

use super::error_estimate::ErrorEstimate;
use super::estimate::estimate;
use super::judge::Judge;
use crate::driver::cost::seconds_of_rays;
use crate::driver::{Failure, MemoryReduction, Options, Outcome, solve, solve_exactly, timed};
use crate::gather::gather_method::GatherMethod;
use crate::goal::{Achieved, EndReason, Goal};
use crate::solved::Solved;

/// Most rays of readings by walks: a minute of two threads. Chosen.
const MOST_RAYS_OF_WALKS: f64 = 2e8;

/// Rays of walks over those by which their standard deviation would be the accuracy: they are asked for 0.7 of it, stop
/// with caution, and are doubled.
const MORE_RAYS: f64 = 4.0;

/// Order of the first runs by exact blocks: the lowest whose error a finer one tells, and whose solution
/// takes next to no time.
pub(super) const FIRST_ORDER: usize = 2;

/// An adaptation of solutions to a goal.
pub(super) struct Adaptation<'a> {
    pub goal: &'a Goal,
    pub work: &'a Work<'a>,
    /// Why exact blocks carry the pairs, where the adaptation decides that.
    pub why: Option<&'a str>,
    judge: OnceCell<Option<Judge>>,
}

/// The error of a run.
pub(super) struct Found {
    /// Relative error; infinite where nothing tells it.
    pub error: f64,
    /// Whether it is as small as wanted.
    pub is_reached: bool,
    /// The method's own estimate, where that was asked for.
    pub own: Option<ErrorEstimate>,
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

impl<'a> Adaptation<'a> {
    pub(super) fn new(goal: &'a Goal, work: &'a Work<'a>, why: Option<&'a str>) -> Self {
        Self { goal, work, why, judge: OnceCell::new() }
    }

    /// The first run of an adaptation.
    pub(super) fn first(&self, options: Options) -> PlannedRun {
        PlannedRun { options, mesh: None, expected: self.goal.accuracy, growth: 1.0 }
    }

    /// Solves `scene` by `planned`, then by what `next` makes of every run and its error.
    pub(super) fn refined(
        &self,
        scene: Scene,
        mut planned: PlannedRun,
        mut next: impl FnMut(&mut Solved, Found) -> Result<NextRun, Failure>,
    ) -> Result<Solved, Failure> {
        let mut begun = Instant::now();
        let outcome = self.solve(&scene, &planned).map_err(advise)?;
        let mut run = Solved::of(scene, planned.options, outcome, None);
        loop {
            if !run.outcome.converged {
                return Ok(self.ended(run, None, EndReason::NotConverged));
            }
            if self.goal.by == GatherMethod::Walks && self.goal.readings.is_some() {
                return Ok(self.by_walks(run));
            }
            // It is made once, however many runs follow.
            begun += self.call_judge(&mut run)?;
            let found = self.found(&mut run, planned.expected)?;
            let error = found.error;
            let following = if found.is_reached { Err(EndReason::Reached) } else { next(&mut run, found)? };
            let finer = match following {
                Ok(next) if self.walks_pay(&run, next.growth) => return Ok(self.by_walks(run)),
                Ok(next) if !self.work.fits(begun.elapsed().mul_f64(next.growth)) => Err(EndReason::Time),
                Ok(next) => {
                    (begun, planned) = (Instant::now(), next);
                    self.finer(&run, &planned)?
                }
                Err(end) => Err(end),
            };
            match finer {
                Ok(outcome) => run = Solved::of(run.scene, planned.options, outcome, None),
                Err(EndReason::Finest | EndReason::Unknowns | EndReason::Memory)
                    if self.walks_pay(&run, f64::INFINITY) =>
                {
                    return Ok(self.by_walks(run));
                }
                Err(end) => return Ok(self.ended(run, Some(error).filter(|error| error.is_finite()), end)),
            }
        }
    }

    /// A run whose light is read by walks.
    fn by_walks(&self, mut run: Solved) -> Solved {
        run.achieved = Some(Achieved::by_walks(self.goal));
        run
    }

    /// The finest run with its error.
    fn ended(&self, mut run: Solved, error: Option<f64>, end: EndReason) -> Solved {
        run.achieved = Some(Achieved::new(self.goal, error, end));
        run
    }

    fn solve(&self, scene: &Scene, planned: &PlannedRun) -> Result<Outcome, Failure> {
        match self.why {
            None => solve(scene, &planned.options, self.work),
            Some(why) => solve_exactly(scene, &planned.options, why, planned.mesh.as_ref(), self.work),
        }
    }

    /// The error of a run that is expected to have about the error `expected`: as the judge finds it, where an error
    /// as small as is wanted shows there; else as the method estimates it, times the factor that the judge finds.
    fn found(&self, run: &mut Solved, expected: f64) -> Result<Found, Failure> {
        let wanted = self.goal.accuracy;
        let judge = self.judge.get().and_then(Option::as_ref);
        let verdict = judge.map(|judge| self.estimated(run, |run| self.verdict(judge, run))).transpose()?;
        if let (Some(verdict), Some(Judge { is_sharp: true, .. })) = (&verdict, judge) {
            let error = verdict.bound();
            return Ok(Found { error, is_reached: error <= wanted, own: None });
        }
        let mut own = self.own(run, expected)?;
        // Light that was gathered for a larger error may hide as much as is wanted.
        if expected > wanted && own.error <= wanted {
            own = self.own(run, wanted)?;
        }
        let error = own.error * verdict.map_or(1.0, |verdict| verdict.factor(own.error));
        Ok(Found { error, is_reached: error <= wanted, own: Some(own) })
    }

    /// Makes the judge if `run` is the first; gives the time that this took.
    fn call_judge(&self, run: &mut Solved) -> Result<Duration, Failure> {
        if self.judge.get().is_some() {
            return Ok(Duration::ZERO);
        }
        let before = run.outcome.seconds.estimate;
        let made = self.estimated(run, |run| {
            let make = || Judge::of(self.goal, run, self.work);
            run.options.in_threads(self.work.ranks, make)
        })?;
        self.judge.get_or_init(|| made);
        Ok(run.outcome.seconds.estimate - before)
    }

    /// The judge's verdict on the light of a run.
    fn verdict(&self, judge: &Judge, run: &Solved) -> Result<Verdict, Failure> {
        run.options.in_threads(self.work.ranks, || judge.on(run, self.goal, self.work))
    }

    /// The method's own estimate of the error of a run.
    pub(super) fn own(&self, run: &mut Solved, expected: f64) -> Result<ErrorEstimate, Failure> {
        self.estimated(run, |run| estimate(run, self.goal, expected, self.work))
    }

    /// A part of the estimation of the error of a run, timed.
    fn estimated<T>(
        &self,
        run: &mut Solved,
        part: impl FnOnce(&Solved) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let mut taken = Duration::ZERO;
        let estimate = timed(&mut taken, || self.work.during(Stage::Estimate, || part(run)))?;
        run.outcome.seconds.estimate += taken;
        Ok(estimate)
    }

    /// Whether it takes less to read the goal's readings by walks, unless they are to be read in another way, than
    /// a run that takes `growth` times as long as `run`.
    fn walks_pay(&self, run: &Solved, growth: f64) -> bool {
        let Some((readings, judge)) = self.goal.readings.zip(self.judge.get().and_then(Option::as_ref))
        else {
            return false;
        };
        if self.goal.by != GatherMethod::Auto {
            return false;
        }
        let rays = MORE_RAYS * readings as f64 * judge.price() / self.goal.accuracy.powi(2);
        let seconds = seconds_of_rays(rays);
        let is_soon = rays < MOST_RAYS_OF_WALKS && self.work.fits(Duration::from_secs_f64(seconds));
        is_soon && seconds < growth * run.outcome.seconds_by_counts()
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
