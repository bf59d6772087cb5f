//! Refinement by more rays, and elements as fine as these support.

use std::time::Instant;

use radiosity_scene::Scene;
use radiosity_work::Work;

use crate::driver::{Failure, MOST_RAYS, Options, Outcome, Sampling, solve};

use super::achieved::{Achieved, Adapted, EndReason};
use super::goal::{Aim, Goal};
use super::run::{advise, estimated, finer};

/// Highest order of elements that rays carry: the largest that their grades know.
const RAYS_ORDER: usize = 2;

/// Least and largest factor on the rays from run to run: with less than twice as many the error hardly falls,
/// and more than sixteen times may be asked for by an estimate that is off.
const MORE: [f64; 2] = [2.0, 16.0];

/// Solves `scene` by more and more rays, and elements as fine as these support, until the error that rays
/// leave is small enough.
pub(super) fn by_rays(
    scene: &Scene,
    options: &Options,
    goal: &Goal,
    work: &Work<'_>,
) -> Result<Adapted, Failure> {
    let order = options.order.max(RAYS_ORDER);
    let mut chosen = Options { order, rays: Some(options.ray_budget(scene)), ..*options };
    let mut begun = Instant::now();
    let mut outcome = solve(scene, &chosen, work).map_err(advise)?;
    loop {
        let Some(Sampling { rays, planned, error: of_rays, .. }) = outcome.sampling else {
            unreachable!("rays carried the pairs")
        };
        let error = match goal.of {
            Aim::Solution => of_rays,
            Aim::Gathered | Aim::Points | Aim::Seen if outcome.converged => {
                Some(estimated(scene, &mut outcome, &chosen, goal, goal.accuracy, work)?.error)
            }
            Aim::Gathered | Aim::Points | Aim::Seen => None,
        };
        let end = match () {
            () if !outcome.converged => Some(EndReason::NotConverged),
            () if error.is_some_and(|error| error <= goal.accuracy) => Some(EndReason::Reached),
            () if rays < planned && work.is_late() => Some(EndReason::Time),
            () if rays < planned => Some(EndReason::Stopped),
            () if rays >= MOST_RAYS => Some(EndReason::Finest),
            () => None,
        };
        let ended = |outcome, end| {
            Ok(Adapted { outcome, options: chosen, achieved: Achieved::new(goal, error, end) })
        };
        if let Some(end) = end {
            return ended(outcome, end);
        }
        let factor = error.map_or(MORE[1], |error| (error / goal.accuracy).powi(2).clamp(MORE[0], MORE[1]));
        let more = ((rays as f64 * factor) as u64).min(MOST_RAYS);
        if !work.fits(begun.elapsed().mul_f64(MORE[0])) {
            return ended(outcome, EndReason::Time);
        }
        begun = Instant::now();
        match finer(solve(scene, &Options { rays: Some(more), ..chosen }, work))? {
            Ok(finer) if is_worse(&finer, &outcome) => {
                return ended(outcome, if work.is_late() { EndReason::Time } else { EndReason::Stopped });
            }
            Ok(finer) => (outcome, chosen.rays) = (finer, Some(more)),
            Err(end) => return ended(outcome, end),
        }
    }
}

/// Whether `finer` was stopped before it had sent more rays than `before`.
fn is_worse(finer: &Outcome, before: &Outcome) -> bool {
    let rays = |outcome: &Outcome| outcome.sampling.map_or(0, |sampling| sampling.rays);
    rays(finer) <= rays(before)
}
