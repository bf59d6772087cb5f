//! Refinement by more rays, and elements as fine as these support.

use radiosity_scene::Scene;

use super::run::{Adaptation, PlannedRun};
use crate::driver::{Failure, MOST_RAYS, Options, Sampling};
use crate::goal::EndReason;
use crate::solved::Solved;

/// Highest order of elements that rays carry: the largest that their grades know.
const RAYS_ORDER: usize = 2;

/// Least and largest factor on the rays from run to run: with less than twice as many the error hardly falls,
/// and more than sixteen times may be asked for by an estimate that is off.
const MORE: [f64; 2] = [2.0, 16.0];

/// Solves `scene` by more and more rays, until the error that they leave is small enough.
pub(super) fn by_rays(scene: Scene, options: &Options, adaptation: &Adaptation) -> Result<Solved, Failure> {
    let order = options.order.max(RAYS_ORDER);
    let first = Options { order, rays: Some(options.ray_budget(&scene)), ..*options };
    adaptation.refined(scene, adaptation.first(first), |run, found| {
        let Some(Sampling { rays, planned, .. }) = run.outcome.sampling else {
            unreachable!("rays carried the pairs")
        };
        if rays < planned {
            return Ok(Err(adaptation.stopped()));
        }
        if rays >= MOST_RAYS {
            return Ok(Err(EndReason::Finest));
        }
        let growth = (found.error / adaptation.goal.accuracy).powi(2).clamp(MORE[0], MORE[1]);
        let more = (growth * rays as f64) as u64;
        let options = Options { rays: Some(more.min(MOST_RAYS)), ..run.options };
        Ok(Ok(PlannedRun { growth, ..adaptation.first(options) }))
    })
}
