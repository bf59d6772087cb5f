//! Adaptation: solves on finer and finer discretisations until a wanted accuracy is reached.
//!
//! Each run has more polynomials or elements than the one before, and more accurate transfers. Its error is estimated
//! from light gathered at points, plus what transfers and shadows may miss: that of the polynomials by what is gathered
//! beside them (`estimate`), that of gathered light by what is gathered where rays from its points end (`gathered`).
//! Against exact answers and much finer runs the estimate of polynomials is within a factor of three of the error
//! (`cargo test --release --test stress -- --ignored`).
//!
//! In a scene without shadows the radiosity is smooth except at edges where surfaces meet, and layers graded towards
//! them converge fastest. Shadow edges lie anywhere, and so do the kinks on a surface that bends away from its light,
//! where the light crosses its horizon: there the elements are cut evenly.

mod goal;
mod points;
mod gathered;
mod estimate;

use std::time::{Duration, Instant};

use radiosity_solvers::SolveError;
use serde::{Deserialize, Serialize};

use crate::elements::basis::HIGHEST_ORDER;
use crate::elements::cells::Layers;
use crate::elements::{Discretization, Subdivide};
use crate::scene::Scene;
use crate::solve::{
    Choice, Failure, Fit, MOST_RAYS, Options, Outcome, Progress, Sampling, Transport, in_threads, solve,
    solve_exactly, timed,
};
use crate::visibility::Visibility;

use estimate::estimate;

pub use goal::{Aim, Goal};

/// The finest run and its accuracy.
#[derive(Debug)]
pub struct Adapted {
    /// The finest possible run.
    pub outcome: Outcome,
    /// Its options.
    pub options: Options,
    /// The accuracy that it reached.
    pub achieved: Achieved,
}

/// The accuracy that an adaptation reached.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Achieved {
    /// Estimated relative error of the finest run; None where its solver did not converge.
    pub estimate: Option<f64>,
    /// Of what.
    #[serde(default)]
    pub of: Aim,
    /// Why no finer run followed.
    pub end: End,
}

impl Achieved {
    /// Whether the estimate is as small as wanted.
    pub fn reached(&self) -> bool {
        self.end == End::Reached
    }
}

/// Why an adaptation ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum End {
    /// The estimate is as small as wanted.
    Reached,
    /// The sequence has no finer run.
    Finest,
    /// The next run would have more unknowns than allowed.
    Unknowns,
    /// The next run would need more memory than allowed.
    Memory,
    /// The solver did not converge in the next run, or in the first.
    NotConverged,
    /// The next run would have ended after [`Options::deadline`], or its rays were stopped there.
    Time,
    /// The caller raised [`Options::stop`].
    Stopped,
}

/// One discretisation of the sequence.
#[derive(Clone, Copy, Debug)]
struct Rung {
    order: usize,
    layers: usize,
    /// Cuts along u and v; None leaves the choice open.
    cuts: Option<usize>,
}

/// For scenes without shadows and kinks. Chosen; not tuned.
const GRADED: [Rung; 8] = [
    Rung { order: FIRST_ORDER, layers: 0, cuts: None },
    Rung { order: 4, layers: 0, cuts: None },
    Rung { order: 4, layers: 1, cuts: None },
    Rung { order: 6, layers: 1, cuts: None },
    Rung { order: 6, layers: 2, cuts: None },
    Rung { order: 8, layers: 2, cuts: None },
    Rung { order: 8, layers: 3, cuts: None },
    Rung { order: 10, layers: 3, cuts: None },
];

/// For scenes with shadows or kinks. Chosen; not tuned.
const EVEN: [Rung; 6] = [
    Rung { order: FIRST_ORDER, layers: 0, cuts: None },
    Rung { order: 3, layers: 0, cuts: Some(2) },
    Rung { order: 4, layers: 0, cuts: Some(4) },
    Rung { order: 6, layers: 0, cuts: Some(4) },
    Rung { order: 6, layers: 0, cuts: Some(8) },
    Rung { order: 8, layers: 0, cuts: Some(8) },
];

/// Most surfaces of a small scene. Chosen.
const FEW: usize = 300;

/// Why small scenes are solved by exact blocks.
const NO_ERROR_OF_ELEMENTS: &str =
    "an accuracy of the polynomials is asked for, and rays do not tell the error of elements";

/// Order of the first rungs. Chosen; not tuned.
const FIRST_ORDER: usize = 2;

/// Highest order of elements that rays carry: the largest that their grades know.
const RAYS_ORDER: usize = 2;

/// Least and largest factor on the rays from run to run. Chosen; not tuned.
const MORE: [f64; 2] = [2.0, 16.0];

/// Factor on the accuracies of transfers and shadows from run to run. Chosen; not tuned.
const SHARPENING: f64 = 0.7;

/// Solves `scene` on finer and finer discretisations until the estimated error is small enough, or the next run would
/// be too large or end too late. A finer run that does not fit into memory, or whose solver does not converge, also ends the sequence.
///
/// Order and layers in `options` are lower bounds, `eps` and `shadow_eps` upper bounds; given cuts stay. `progress` is
/// called for every run from its beginning.
///
/// # Errors
/// Any error of the first run; of later runs those that do not end the sequence.
pub fn adapt(
    scene: &Scene,
    options: &Options,
    goal: Goal,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Adapted, Failure> {
    let choice = in_threads(options.threads, || Choice::of(scene, options))?;
    if is_by_rays(scene, options, goal, &choice) {
        return by_rays(scene, options, goal, progress);
    }
    let why = if choice.sampled { NO_ERROR_OF_ELEMENTS } else { &choice.why };
    let exactly = |options: &Options| solve_exactly(scene, options, why, progress);
    let visibility = Visibility::new(scene, options.into());
    let occluded = visibility.any_shadow();
    let rungs: &[Rung] = if occluded || visibility.any_horizon() { &EVEN } else { &GRADED };
    let mut plan: Vec<Options> =
        rungs.iter().enumerate().map(|(k, rung)| rung.options(k, options, goal.accuracy)).collect();
    plan.dedup_by_key(|o| (o.order, o.layers.count, o.subdivide));
    let mut plan = plan.into_iter();
    let mut chosen = plan.next().expect("there is a first rung");
    let mut begun = Instant::now();
    let mut outcome = exactly(&chosen).map_err(advise)?;
    if !outcome.converged {
        let achieved = Achieved { estimate: None, of: goal.of, end: End::NotConverged };
        return Ok(Adapted { outcome, options: chosen, achieved });
    }
    let mut error;
    let end = loop {
        error = estimated(scene, &mut outcome, &chosen, goal, progress)?;
        if error <= goal.accuracy {
            break End::Reached;
        }
        let Some(options) = plan.next() else { break End::Finest };
        let unknowns = unknowns(scene, &options, occluded)?;
        if unknowns > goal.most_unknowns {
            break End::Unknowns;
        }
        let growth = unknowns as f64 / outcome.solution.elements().coefficients() as f64;
        if !fits(options.deadline, begun.elapsed().mul_f64(growth.powi(2))) {
            break End::Time;
        }
        begun = Instant::now();
        match finer(exactly(&options))? {
            Ok(finer) => (outcome, chosen) = (finer, options),
            Err(end) => break end,
        }
    };
    Ok(Adapted { outcome, options: chosen, achieved: Achieved { estimate: Some(error), of: goal.of, end } })
}

/// Whether rays carry the pairs: where polynomials are the goal, in small scenes only if they are asked for, because their
/// own error tells nothing of that of elements.
fn is_by_rays(scene: &Scene, options: &Options, goal: Goal, choice: &Choice) -> bool {
    let is_asked_for = options.transport == Transport::Sampled || options.rays.is_some();
    choice.sampled && (goal.of == Aim::Gathered || is_asked_for || scene.surfaces.len() > FEW)
}

/// Solves `scene` by more and more rays, and elements as fine as these support, until the error that rays leave is
/// small enough.
fn by_rays(
    scene: &Scene,
    options: &Options,
    goal: Goal,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Adapted, Failure> {
    let order = options.order.max(RAYS_ORDER);
    let mut chosen = Options { order, rays: Some(options.ray_budget(scene)), ..*options };
    let mut begun = Instant::now();
    let mut outcome = solve(scene, &chosen, progress).map_err(advise)?;
    loop {
        let Some(Sampling { rays, planned, error: of_rays, .. }) = outcome.sampling else {
            unreachable!("rays carried the pairs")
        };
        let error = match goal.of {
            Aim::Solution => of_rays,
            Aim::Gathered if outcome.converged => {
                Some(estimated(scene, &mut outcome, &chosen, goal, progress)?)
            }
            Aim::Gathered => None,
        };
        let end = match () {
            () if !outcome.converged => Some(End::NotConverged),
            () if error.is_some_and(|error| error <= goal.accuracy) => Some(End::Reached),
            () if rays < planned && options.is_late() => Some(End::Time),
            () if rays < planned => Some(End::Stopped),
            () if rays >= MOST_RAYS => Some(End::Finest),
            () => None,
        };
        let ended = |outcome, end| {
            Ok(Adapted { outcome, options: chosen, achieved: Achieved { estimate: error, of: goal.of, end } })
        };
        if let Some(end) = end {
            return ended(outcome, end);
        }
        let factor = error.map_or(MORE[1], |error| (error / goal.accuracy).powi(2).clamp(MORE[0], MORE[1]));
        let more = ((rays as f64 * factor) as u64).min(MOST_RAYS);
        if !fits(options.deadline, begun.elapsed().mul_f64(MORE[0])) {
            return ended(outcome, End::Time);
        }
        begun = Instant::now();
        match finer(solve(scene, &Options { rays: Some(more), ..chosen }, progress))? {
            Ok(finer) if is_worse(&finer, &outcome) => {
                return ended(outcome, if options.is_late() { End::Time } else { End::Stopped });
            }
            Ok(finer) => (outcome, chosen.rays) = (finer, Some(more)),
            Err(end) => return ended(outcome, end),
        }
    }
}

/// The estimated error of a run, timed.
fn estimated(
    scene: &Scene,
    outcome: &mut Outcome,
    options: &Options,
    goal: Goal,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<f64, Failure> {
    let mut taken = Duration::ZERO;
    let error = timed(&mut taken, || estimate(scene, outcome, options, goal, progress))?;
    outcome.seconds.estimate = taken;
    progress(Progress::Finished("estimate", taken));
    Ok(error)
}

/// Whether a run that would take so long ends in time.
fn fits(deadline: Option<Instant>, run: Duration) -> bool {
    deadline.is_none_or(|deadline| deadline.saturating_duration_since(Instant::now()) >= run)
}

/// Whether `finer` was stopped before it had sent more rays than `before`.
fn is_worse(finer: &Outcome, before: &Outcome) -> bool {
    let rays = |outcome: &Outcome| outcome.sampling.map_or(0, |sampling| sampling.rays);
    rays(finer) <= rays(before)
}

/// A run after the first, or the reason why it ends the sequence.
fn finer(run: Result<Outcome, Failure>) -> Result<Result<Outcome, End>, Failure> {
    match run {
        Ok(outcome) if outcome.converged => Ok(Ok(outcome)),
        Ok(_) | Err(Failure::Solver { source: SolveError::NotConverged { .. }, .. }) => {
            Ok(Err(End::NotConverged))
        }
        Err(Failure::Memory { .. }) => Ok(Err(End::Memory)),
        Err(failure) => Err(failure),
    }
}

/// Adds that lower orders than that of the first run are possible only without a wanted accuracy.
fn advise(failure: Failure) -> Failure {
    let Failure::Memory { needed, allowed, fits } = failure else { return failure };
    let fit = |fit| match fit {
        Fit::Order(order) if order < FIRST_ORDER => Fit::OrderAlone(order),
        fit => fit,
    };
    Failure::Memory { needed, allowed, fits: fits.into_iter().map(fit).collect() }
}

impl Rung {
    fn options(&self, place: usize, least: &Options, accuracy: f64) -> Options {
        let sharper = SHARPENING.powf(place as f64);
        Options {
            order: (least.order.max(FIRST_ORDER) + self.order - FIRST_ORDER).min(HIGHEST_ORDER),
            layers: Layers { count: self.layers + least.layers.count, ..least.layers },
            subdivide: least.subdivide.or(self.cuts),
            eps: least.eps.min(accuracy / 4.0) * sharper,
            shadow_eps: least.shadow_eps.min(accuracy) * sharper,
            ..*least
        }
    }
}

fn unknowns(scene: &Scene, options: &Options, occluded: bool) -> Result<usize, Failure> {
    let Options { order, space, layers, .. } = *options;
    let subdivide = options.subdivide.map_or(Subdivide::Auto { occluded }, Subdivide::Uniform);
    Ok(options.elements(scene, &Discretization { order, space, subdivide, layers })?.coefficients())
}
