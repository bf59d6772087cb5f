//! Runs that are held against the paper's, whose light is integrated and never carried by rays.

use std::error::Error;

use cpu_time::ProcessTime;
use radiosity::Work;
use radiosity::published::zatz1993::transfers::{HybridReading, PaperRules};
use radiosity::scene::Scene;
use radiosity::solve::{Options, Outcome, Transport, solve};

/// The rule of the paper: of its readings the nearest to the numbers it prints.
pub(crate) const HYBRID: PaperRules = PaperRules::Hybrid(HybridReading::H1);

/// The rules that are held against each other, with their names.
pub(crate) const RULES: [(&str, Option<PaperRules>); 2] = [("1993", Some(HYBRID)), ("ours", None)];

/// The outcome of a run, and its CPU time (s).
pub(crate) struct Reproduced {
    pub(crate) outcome: Outcome,
    pub(crate) seconds: f64,
}

/// Solves a scene by one of the rules.
///
/// # Errors
/// What cannot be solved, and pairs that rays carried: all of them, or by the rules of 1993 any.
pub(crate) fn reproduced(
    scene: &Scene,
    kernel: Option<PaperRules>,
    options: &Options,
) -> Result<Reproduced, Box<dyn Error>> {
    let options = Options { kernel, transport: Transport::Exact, ..*options };
    let start = ProcessTime::now();
    let outcome = solve(scene, &options, &Work::alone())?;
    let seconds = start.elapsed().as_secs_f64();
    let by_rays = outcome.choice.sampled || outcome.sampling.is_some();
    if by_rays || kernel.is_some() && outcome.pairs.by_rays > 0 {
        return Err("rays carried pairs of elements: that is no reproduction".into());
    }
    Ok(Reproduced { outcome, seconds })
}
