//! Refinement of hierarchical radiosity: weaker and weaker links.

use radiosity_scene::Scene;

use super::run::{Adaptation, PlannedRun};
use crate::driver::{Failure, Options};
use crate::goal::EndReason;
use crate::solved::Solved;

/// Greatest power of the first links, in parts of the wanted accuracy: the errors of many links add up to
/// more than that of one.
const FIRST: f64 = 0.1;
/// Factor on the power of links from run to run: each takes some four times as long as the one before.
const WEAKER: f64 = 0.25;
/// Least power of links, below which there are more links than memory holds.
const LEAST: f64 = 1e-8;

/// Elements of a run over those of the run before, and of its time, about. From the Cornell box.
const GROWTH: f64 = 4.0;

/// Solves `scene` by weaker and weaker links.
pub(super) fn by_links(scene: Scene, options: &Options, adaptation: &Adaptation) -> Result<Solved, Failure> {
    let eps = options.eps.min(FIRST * adaptation.goal.accuracy);
    adaptation.refined(scene, adaptation.first(Options { eps, ..*options }), |run, _| {
        let options = Options { eps: WEAKER * run.options.eps, ..run.options };
        let is_possible = options.eps >= LEAST;
        let weaker = PlannedRun { growth: GROWTH, ..adaptation.first(options) };
        Ok(is_possible.then_some(weaker).ok_or(EndReason::Finest))
    })
}
