//! Refinement of hierarchical radiosity: weaker and weaker links.

use std::time::Instant;

use radiosity_scene::Scene;
use radiosity_work::Work;

use crate::driver::{Failure, Options, solve};

use super::achieved::{Achieved, Adapted, EndReason};
use super::goal::Goal;
use super::run::{estimated, finer};

/// Greatest power of the first links, in parts of the wanted accuracy: the errors of many links add up to
/// more than that of one.
const FIRST: f64 = 0.1;
/// Factor on the power of links from run to run: each takes some four times as long as the one before.
const WEAKER: f64 = 0.25;
/// Least power of links, below which there are more links than memory holds.
const LEAST: f64 = 1e-8;

/// Elements of a run over those of the run before, and of its time, about. From the Cornell box.
const GROWTH: f64 = 4.0;

/// Solves `scene` by weaker and weaker links, until the error is small enough.
pub(super) fn by_links(
    scene: &Scene,
    options: &Options,
    goal: &Goal,
    work: &Work<'_>,
) -> Result<Adapted, Failure> {
    let mut chosen = Options { eps: options.eps.min(FIRST * goal.accuracy), ..*options };
    let mut begun = Instant::now();
    let mut outcome = solve(scene, &chosen, work)?;
    loop {
        let error = estimated(scene, &mut outcome, &chosen, goal, goal.accuracy, work)?.error;
        let weaker = Options { eps: WEAKER * chosen.eps, ..chosen };
        let end = match () {
            () if error <= goal.accuracy => Some(EndReason::Reached),
            () if weaker.eps < LEAST => Some(EndReason::Finest),
            () if !work.fits(begun.elapsed().mul_f64(GROWTH)) => Some(EndReason::Time),
            () => None,
        };
        let end = match end {
            Some(end) => end,
            None => {
                begun = Instant::now();
                match finer(solve(scene, &weaker, work))? {
                    Ok(finer) => {
                        (outcome, chosen) = (finer, weaker);
                        continue;
                    }
                    Err(end) => end,
                }
            }
        };
        let achieved = Achieved::new(goal, Some(error), end);
        return Ok(Adapted { outcome, options: chosen, achieved });
    }
}
