//! Adaptation: the discretisation that a wanted accuracy needs, found by solving on finer and finer ones.
//!
//! Every run is finer than the one before in its polynomials or its elements, and its transfers are more accurate. Its error
//! is told from light gathered anew at points (`estimate`), what transfers and shadows may miss added. Against exact answers
//! and much finer runs the estimate is within a factor of three of the error (tests/stress: estimate, convex).
//!
//! In a scene without shadows the radiosity is smooth but for the edges where surfaces meet, and layers graded towards them
//! converge fastest. Shadow edges lie anywhere, and so do the kinks on a surface that bends away from what lights it, where
//! its horizon crosses that: there the elements are cut evenly.

mod estimate;

use std::time::Duration;

use radiosity_solvers::SolveError;
use serde::{Deserialize, Serialize};

use crate::elements::basis::HIGHEST_ORDER;
use crate::elements::cells::Layers;
use crate::elements::{Discretization, Subdivide};
use crate::scene::Scene;
use crate::solve::{Failure, Fit, Options, Outcome, Progress, solve, timed};
use crate::visibility::Visibility;

use estimate::estimate;

/// What is wanted.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    /// Relative error of the radiosity in L2, less what is emitted, all bands pooled.
    pub accuracy: f64,
    /// No run with more unknowns per band is begun, the first excepted.
    pub most_unknowns: usize,
}

impl Goal {
    /// `accuracy` with at most 8000 unknowns a band: half a gigabyte for each matrix.
    pub fn new(accuracy: f64) -> Self {
        Self { accuracy, most_unknowns: 8000 }
    }
}

/// The finest run with what it may miss.
#[derive(Debug)]
pub struct Adapted {
    /// The finest run that could be done.
    pub outcome: Outcome,
    /// Its options.
    pub options: Options,
    /// How far it came.
    pub achieved: Achieved,
}

/// How far an adaptation came.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Achieved {
    /// Estimated relative error of the finest run; None where its solver did not converge.
    pub estimate: Option<f64>,
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
    /// There is no finer run in the sequence.
    Finest,
    /// The next run would have more unknowns than allowed.
    Unknowns,
    /// The next run would need more memory than allowed.
    Memory,
    /// The solver did not converge in the next run; where there is no run before, in this one.
    NotConverged,
}

/// One discretisation of the sequence.
#[derive(Clone, Copy, Debug)]
struct Rung {
    order: usize,
    layers: usize,
    /// Cuts along u and v; None leaves the choice open.
    cuts: Option<usize>,
}

/// For scenes in which nothing hides anything and nothing bends away.
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

/// For scenes with shadows or kinks.
const EVEN: [Rung; 6] = [
    Rung { order: FIRST_ORDER, layers: 0, cuts: None },
    Rung { order: 3, layers: 0, cuts: Some(2) },
    Rung { order: 4, layers: 0, cuts: Some(4) },
    Rung { order: 6, layers: 0, cuts: Some(4) },
    Rung { order: 6, layers: 0, cuts: Some(8) },
    Rung { order: 8, layers: 0, cuts: Some(8) },
];

/// Order of the first rungs.
const FIRST_ORDER: usize = 2;

/// Accuracies of transfers and shadows fall by this factor from run to run.
const SHARPENING: f64 = 0.7;

/// Solves `scene` on finer and finer discretisations until the estimated error is as small as wanted, or the next would
/// be too large. A finer run that does not fit into memory, or whose solver does not converge, ends the sequence as well.
///
/// Of `options`, order and layers are the least to begin with, `eps` and `shadow_eps` the loosest; cuts that are given
/// stay. `progress` hears every run from its beginning.
///
/// # Errors
/// Whatever fails in the first run, and what else fails later.
pub fn adapt(
    scene: &Scene,
    options: &Options,
    goal: Goal,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Adapted, Failure> {
    let visibility = Visibility::new(scene, options.into());
    let occluded = visibility.any_shadow();
    let rungs: &[Rung] = if occluded || visibility.any_horizon() { &EVEN } else { &GRADED };
    let mut plan: Vec<Options> =
        rungs.iter().enumerate().map(|(k, rung)| rung.options(k, options, goal.accuracy)).collect();
    plan.dedup_by_key(|o| (o.order, o.layers.count, o.subdivide));
    let mut plan = plan.into_iter();
    let mut chosen = plan.next().expect("there is a first rung");
    let mut outcome = solve(scene, &chosen, progress).map_err(advise)?;
    if !outcome.converged {
        let achieved = Achieved { estimate: None, end: End::NotConverged };
        return Ok(Adapted { outcome, options: chosen, achieved });
    }
    let mut error;
    let end = loop {
        let mut taken = Duration::ZERO;
        error = timed(&mut taken, || estimate(scene, &outcome, &chosen, goal.accuracy, progress))?;
        outcome.seconds.estimate = taken;
        progress(Progress::Finished("estimate", outcome.seconds.estimate));
        if error <= goal.accuracy {
            break End::Reached;
        }
        let Some(options) = plan.next() else { break End::Finest };
        if unknowns(scene, &options, occluded)? > goal.most_unknowns {
            break End::Unknowns;
        }
        match finer(scene, &options, progress)? {
            Ok(finer) => (outcome, chosen) = (finer, options),
            Err(end) => break end,
        }
    };
    Ok(Adapted { outcome, options: chosen, achieved: Achieved { estimate: Some(error), end } })
}

/// A run after the first, or why it ends the sequence.
fn finer(
    scene: &Scene,
    options: &Options,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Result<Outcome, End>, Failure> {
    match solve(scene, options, progress) {
        Ok(outcome) if outcome.converged => Ok(Ok(outcome)),
        Ok(_) | Err(Failure::Solver { source: SolveError::NotConverged { .. }, .. }) => {
            Ok(Err(End::NotConverged))
        }
        Err(Failure::Memory { .. }) => Ok(Err(End::Memory)),
        Err(failure) => Err(failure),
    }
}

/// Orders below the first rung's can be had only without a wanted accuracy.
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
