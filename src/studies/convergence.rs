//! Convergence: one scene solved at rising orders, and on meshes with more and more layers; how its error falls.
//!
//! The error of a run is its [distance](crate::studies::error_norm) from a reference. Without one this is the finest
//! run, whose own unknown error then adds to that of every other run. Between two runs of n and n′ unknowns on the same
//! number of layers the rate is
//!
//! ```text
//! log(error / error′) / log(n′ / n) .
//! ```

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::elements::cells::Layers;
use crate::scene::Scene;
use crate::solution::Solution;
use crate::solve::{Failure, Options, Outcome, Progress, solve};
use crate::studies::error_norm::distance;

/// One solved discretisation.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Order of the basis.
    pub order: usize,
    /// Layers of graded elements.
    pub layers: usize,
    /// Number of elements.
    pub elements: usize,
    /// Number of coefficients per band.
    pub unknowns: usize,
    /// Terms of the kernel's quadrature rules.
    pub samples: u64,
    /// Segments tested for visibility.
    pub rays: u64,
    /// Wall time from elements to coefficients (s).
    pub seconds: f64,
    /// Relative error; None for the run that is itself the reference.
    pub error: Option<f64>,
    /// Order of convergence in the unknowns from the run before; None without one, or with equal unknowns.
    pub rate: Option<f64>,
}

/// The reference that errors are measured against.
pub enum Reference<'a> {
    /// The last and finest run.
    FinestRun,
    /// A function that gives the error of a solution.
    Given(&'a dyn Fn(&Solution) -> f64),
}

/// Solves `scene` at orders 0 to `options.order` on 0 to `options.layers.count` layers, layers slowest.
///
/// `progress` gets the finished part of the work, from 0 to 1; from any thread.
///
/// # Errors
/// The first run that fails.
pub fn convergence(
    scene: &Scene,
    options: &Options,
    reference: &Reference,
    progress: &(dyn Fn(f64) + Sync),
) -> Result<Vec<Run>, Failure> {
    let plan = plan(options);
    let work: Vec<f64> = plan.iter().map(work).collect();
    let all: f64 = work.iter().sum();
    let mut outcomes = Vec::with_capacity(plan.len());
    let mut before = 0.0;
    for (options, work) in plan.iter().zip(work) {
        let furthest = AtomicUsize::new(0);
        let hear = |stage| {
            if let Progress::Blocks(done, total) = stage {
                let done = furthest.fetch_max(done, Ordering::Relaxed).max(done);
                progress((before + work * done as f64 / total.max(1) as f64) / all);
            }
        };
        outcomes.push(solve(scene, options, &hear)?);
        before += work;
    }
    Ok(runs(&plan, &outcomes, reference))
}

fn plan(options: &Options) -> Vec<Options> {
    let layers = |count| Layers { count, ..options.layers };
    let of_layers =
        |count| (0..=options.order).map(move |order| Options { order, layers: layers(count), ..*options });
    (0..=options.layers.count).flat_map(of_layers).collect()
}

/// Work of a run: about the number of pairs of basis functions.
fn work(options: &Options) -> f64 {
    let cells = (1 + 2 * options.layers.count).pow(2);
    ((cells * options.space.count(options.order)) as f64).powi(2)
}

fn runs(plan: &[Options], outcomes: &[Outcome], reference: &Reference) -> Vec<Run> {
    let finest = &outcomes[outcomes.len() - 1].solution;
    let error = |k: usize| match reference {
        Reference::Given(error) => Some(error(&outcomes[k].solution)),
        Reference::FinestRun if k + 1 == outcomes.len() => None,
        Reference::FinestRun => {
            Some(distance(&outcomes[k].solution, finest).expect("the runs are of one scene"))
        }
    };
    let mut runs: Vec<Run> = Vec::with_capacity(plan.len());
    for (k, (options, outcome)) in plan.iter().zip(outcomes).enumerate() {
        let run = run(options, outcome, error(k));
        let rate = runs.last().and_then(|before| rate(before, &run));
        runs.push(Run { rate, ..run });
    }
    runs
}

fn run(options: &Options, outcome: &Outcome, error: Option<f64>) -> Run {
    let elements = outcome.solution.elements();
    let stages = outcome.seconds;
    Run {
        order: options.order,
        layers: options.layers.count,
        elements: elements.list().len(),
        unknowns: elements.coefficients(),
        samples: outcome.samples,
        rays: outcome.rays,
        seconds: (stages.elements + stages.visibility + stages.blocks + stages.direct + stages.solve)
            .as_secs_f64(),
        error,
        rate: None,
    }
}

fn rate(before: &Run, run: &Run) -> Option<f64> {
    let (old, new) = (before.error?, run.error?);
    // Surfaces that state their own order may leave the unknowns as they are.
    let comparable = before.layers == run.layers && before.unknowns != run.unknowns && old > 0.0 && new > 0.0;
    comparable.then(|| (old / new).ln() / (run.unknowns as f64 / before.unknowns as f64).ln())
}
