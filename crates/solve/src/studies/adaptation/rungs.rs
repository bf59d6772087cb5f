//! Refinement of all elements alike, until the polynomials are accurate.
//!
//! In a scene without shadows the radiosity is smooth except at edges where surfaces meet, and layers graded
//! towards them converge fastest. Shadow edges lie anywhere, and so do the kinks on a surface that bends away
//! from its light, where the light crosses its horizon: there the elements are cut evenly.

use radiosity_elements::basis::HIGHEST_ORDER;
use radiosity_elements::cells::Layers;
use radiosity_elements::{Discretization, Elements};
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;

use super::run::{Adaptation, FIRST_ORDER, PlannedRun};
use crate::driver::{Failure, Options};
use crate::goal::EndReason;
use crate::solved::Solved;
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

/// Solves `scene` by exact blocks on the finest rung that the goal needs.
pub(super) fn by_rungs(
    scene: Scene,
    options: &Options,
    visibility: &Visibility,
    adaptation: &Adaptation,
) -> Result<Solved, Failure> {
    let occluded = visibility.any_shadow();
    let rungs: &[Rung] = if occluded || visibility.any_horizon() { &EVEN } else { &GRADED };
    let rung = |(k, rung): (usize, &Rung)| rung.options(k, options, adaptation.goal.accuracy);
    let mut plan: Vec<Options> = rungs.iter().enumerate().map(rung).collect();
    plan.dedup_by_key(|o| (o.order, o.layers.count, o.subdivide));
    let mut plan = plan.into_iter();
    let first = plan.next().expect("there is a first rung");
    adaptation.refined(scene, adaptation.first(first), |run, _| {
        let Some(options) = plan.next() else { return Ok(Err(EndReason::Finest)) };
        let unknowns = unknowns(&run.scene, &options, occluded)?;
        let growth = adaptation.growth(run, unknowns);
        Ok(growth.map(|growth| PlannedRun { growth, ..adaptation.first(options) }))
    })
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
    let subdivide = options.exact_cuts(occluded);
    Ok(Elements::new(scene, &Discretization { order, space, subdivide, layers })?.coefficients())
}
