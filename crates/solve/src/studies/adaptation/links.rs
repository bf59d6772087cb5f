//! Refinement of hierarchical radiosity: weaker and weaker links.

use std::time::Instant;

use radiosity_scene::Scene;

use crate::driver::{Failure, Options, Progress, solve};

use super::achieved::{Achieved, Adapted, End};
use super::goal::Goal;
use super::run::{estimated, finer, fits};

/// Greatest power of the first links, in parts of the wanted accuracy; factor from run to run; and the least power. Chosen.
const FIRST: f64 = 0.1;
const WEAKER: f64 = 0.25;
const LEAST: f64 = 1e-8;

/// Elements of a run over those of the run before, and of its time, about. From the Cornell box.
const GROWTH: f64 = 4.0;

/// Solves `scene` by weaker and weaker links, until the error is small enough.
pub(super) fn by_links(
    scene: &Scene,
    options: &Options,
    goal: &Goal,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Adapted, Failure> {
    let mut chosen = Options { eps: options.eps.min(FIRST * goal.accuracy), ..*options };
    let mut begun = Instant::now();
    let mut outcome = solve(scene, &chosen, progress)?;
    loop {
        let error = estimated(scene, &mut outcome, &chosen, (goal, goal.accuracy), progress)?.error;
        let weaker = Options { eps: WEAKER * chosen.eps, ..chosen };
        let end = match () {
            () if error <= goal.accuracy => Some(End::Reached),
            () if weaker.eps < LEAST => Some(End::Finest),
            () if !fits(options.deadline, begun.elapsed().mul_f64(GROWTH)) => Some(End::Time),
            () => None,
        };
        let end = match end {
            Some(end) => end,
            None => {
                begun = Instant::now();
                match finer(solve(scene, &weaker, progress))? {
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
