//! Adaptation: the discretisation that a wanted accuracy needs, found by solving on finer and finer ones.
//!
//! Run k + 1 is finer than run k in its polynomials or its elements, and its transfers are more accurate. With B the
//! exact radiosity and d the [distance](crate::distance),
//!
//! ```text
//! d(B_k, B) ≤ d(B_k, B_k₊₁) + d(B_k₊₁, B) ,
//! ```
//!
//! and the last term is the smaller one as long as runs get better. The estimate is d(B_k, B_k₊₁), an error of the run
//! before; the result is the better run k + 1. What no run resolves, both leave out and no estimate shows: surfaces that
//! state their own order and cuts keep them, and what they miss is not seen.
//!
//! In a scene without shadows the radiosity is smooth but for the edges where surfaces meet, and layers graded towards
//! them converge fastest. Shadow edges lie anywhere: where something stands between, the elements are cut evenly.

use crate::distance::distance;
use crate::elements::basis::HIGHEST_ORDER;
use crate::elements::cells::Layers;
use crate::elements::{Discretization, Elements, Subdivide};
use crate::scene::Scene;
use crate::solve::{Failure, Options, Outcome, Progress, solve};
use crate::visibility::{Shadows, Visibility};

/// What is wanted.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    /// Relative error of the radiosity in L2, less what is emitted, all bands pooled.
    pub accuracy: f64,
    /// No run with more unknowns per band is begun, the first two excepted.
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
    /// The finest run.
    pub outcome: Outcome,
    /// Its options.
    pub options: Options,
    /// Estimated relative error, as of the run before it.
    pub estimate: f64,
    /// Whether the estimate is as small as wanted.
    pub reached: bool,
}

/// One discretisation of the sequence.
#[derive(Clone, Copy, Debug)]
struct Rung {
    order: usize,
    layers: usize,
    /// Cuts along u and v; None leaves the choice open.
    cuts: Option<usize>,
}

/// For scenes in which nothing hides anything.
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

/// For scenes with shadows.
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
/// be too large.
///
/// Of `options`, order and layers are the least to begin with, `eps` and `shadow_eps` the loosest; cuts that are given
/// stay. `progress` hears every run from its beginning.
///
/// # Errors
/// The first run that fails.
pub fn adapt(
    scene: &Scene,
    options: &Options,
    goal: Goal,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Adapted, Failure> {
    let shadows = if options.shadows { Shadows::Rays(options.shadow_eps) } else { Shadows::Off };
    let occluded = Visibility::new(scene, shadows).any_shadow();
    let rungs: &[Rung] = if occluded { &EVEN } else { &GRADED };
    let mut plan: Vec<Options> =
        rungs.iter().enumerate().map(|(k, rung)| rung.options(k, options, goal.accuracy)).collect();
    plan.dedup_by_key(|o| (o.order, o.layers.count, o.subdivide));
    let mut plan = plan.into_iter();
    let mut chosen = plan.next().expect("there is a first rung");
    let mut outcome = solve(scene, &chosen, progress)?;
    let mut estimate = f64::INFINITY;
    for options in plan {
        if estimate <= goal.accuracy {
            break;
        }
        if estimate.is_finite() && unknowns(scene, &options, occluded)? > goal.most_unknowns {
            break;
        }
        let finer = solve(scene, &options, progress)?;
        estimate = distance(&outcome.solution, &finer.solution).expect("the runs are of one scene");
        (outcome, chosen) = (finer, options);
    }
    Ok(Adapted { outcome, options: chosen, estimate, reached: estimate <= goal.accuracy })
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
    Ok(Elements::new(scene, &Discretization { order, space, subdivide, layers })?.coefficients())
}
