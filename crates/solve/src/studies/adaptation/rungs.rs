//! Refinement of all elements alike, until the polynomials are accurate.
//!
//! In a scene without shadows the radiosity is smooth except at edges where surfaces meet, and layers graded
//! towards them converge fastest. Shadow edges lie anywhere, and so do the kinks on a surface that bends away
//! from its light, where the light crosses its horizon: there the elements are cut evenly.

use std::time::Instant;

use radiosity_elements::basis::HIGHEST_ORDER;
use radiosity_elements::cells::Layers;
use radiosity_elements::{Discretization, Subdivide};
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;
use radiosity_work::Work;

use super::achieved::{Achieved, Adapted, EndReason};
use super::goal::Goal;
use super::run::{FIRST_ORDER, advise, estimated, finer};
use crate::driver::{Failure, Options, solve_exactly};
use crate::tolerances::SHARPENING_OF_RUNGS;

/// A discretisation of the sequence.
#[derive(Clone, Copy, Debug)]
struct Rung {
    order: usize,
    layers: usize,
    /// Cuts along u and v; None leaves the choice open.
    cuts: Option<usize>,
}

/// Rungs for scenes without shadows and kinks: orders and graded layers in turn, since light is smooth but at
/// edges. An arbitrary choice: coarser steps overshoot what is wanted, finer ones take more runs.
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

/// Rungs for scenes with shadows or kinks: orders and even cuts in turn, since no polynomial follows a
/// shadow. An arbitrary choice.
const EVEN: [Rung; 6] = [
    Rung { order: FIRST_ORDER, layers: 0, cuts: None },
    Rung { order: 3, layers: 0, cuts: Some(2) },
    Rung { order: 4, layers: 0, cuts: Some(4) },
    Rung { order: 6, layers: 0, cuts: Some(4) },
    Rung { order: 6, layers: 0, cuts: Some(8) },
    Rung { order: 8, layers: 0, cuts: Some(8) },
];

/// Solves `scene` by exact blocks, for the reason `why`, on the finest rung that the goal needs.
pub(super) fn by_rungs(
    scene: &Scene,
    options: &Options,
    goal: &Goal,
    why: &str,
    work: &Work<'_>,
) -> Result<Adapted, Failure> {
    let exactly = |options: &Options| solve_exactly(scene, options, why, None, work);
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
        let achieved = Achieved::new(goal, None, EndReason::NotConverged);
        return Ok(Adapted { outcome, options: chosen, achieved });
    }
    let mut error;
    let end = loop {
        error = estimated(scene, &mut outcome, &chosen, goal, goal.accuracy, work)?.error;
        if error <= goal.accuracy {
            break EndReason::Reached;
        }
        let Some(options) = plan.next() else { break EndReason::Finest };
        let unknowns = unknowns(scene, &options, occluded)?;
        if unknowns > goal.most_unknowns {
            break EndReason::Unknowns;
        }
        let growth = unknowns as f64 / outcome.solution.elements().coefficients() as f64;
        if !work.fits(begun.elapsed().mul_f64(growth.powi(2))) {
            break EndReason::Time;
        }
        begun = Instant::now();
        match finer(exactly(&options))? {
            Ok(finer) => (outcome, chosen) = (finer, options),
            Err(end) => break end,
        }
    };
    Ok(Adapted { outcome, options: chosen, achieved: Achieved::new(goal, Some(error), end) })
}

impl Rung {
    fn options(&self, place: usize, least: &Options, accuracy: f64) -> Options {
        let sharper = SHARPENING_OF_RUNGS.powf(place as f64);
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
    Ok(options.elements(scene, &Discretization { order, space, subdivide, layers }, None)?.coefficients())
}
