//! Convergence: one scene solved at rising orders, on meshes with more and more layers, and in other
//! [ways](RunSeries); how its error falls.
//!
//! The error of a run is its [distance](crate::studies::error_norm) from a reference. Without one this is the
//! finest of the uniform runs, whose own unknown error then adds to that of every other run. Between two runs
//! of n and n′ unknowns of one way, on the same number of layers, the rate is
//!
//! ```text
//! log(error / error′) / log(n′ / n) .
//! ```
//!
//! The error of energy of a run is the distance of its variational functional I ([`crate::system::ritz`])
//! from that of the finest uniform run, I*,
//!
//! ```text
//! √((I − I*) / |I*|) ,     I − I* = ½ ‖y − y*‖² in the norm of the system where the spaces are nested.
//! ```

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use radiosity_elements::cells::Layers;
use radiosity_published::bases::Basis;
use radiosity_scene::Scene;
use radiosity_work::{Progress, Stage, Work};

use crate::driver::{
    ColumnChoice, Failure, LightMethod, Model, Options, Outcome, ShotLimit, Shots, Transport, solve,
};
use crate::solution::Solution;
use crate::solved::Solved;
use crate::studies::adaptation::{Aim, Goal};
use crate::studies::error_norm::distance;

/// Powers of the strongest links of the hierarchical runs, in parts of the largest. Chosen: from a tenth of a
/// second to some seconds in the Cornell box.
const LINKS: [f64; 4] = [1e-2, 2.5e-3, 6e-4, 1.5e-4];

/// Accuracies of gathered light that elements are refined for. Chosen.
const WANTED: [f64; 4] = [3e-2, 1e-2, 3e-3, 1e-3];

/// Cells of a surface along u and v of the runs by constants and by tents. Chosen: about as many unknowns as
/// polynomials of the usual orders.
const CELLS: [usize; 5] = [1, 2, 4, 8, 16];

/// Rays of the sampled runs: from 2¹⁷ by factors of four. Chosen.
const RAYS: [u64; 4] = [1 << 17, 1 << 19, 1 << 21, 1 << 23];

/// A way in which a sequence of runs gets finer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum RunSeries {
    /// Higher orders, and more layers, on all surfaces alike.
    Uniform,
    /// Hierarchical radiosity on constants, by weaker and weaker links.
    Hierarchical,
    /// Elements cut, or of higher order, where they bear the error of gathered light.
    Hp,
    /// More and more rays at the highest order.
    Sampled,
    /// Constants on finer and finer cells.
    Constant,
    /// Tents on finer and finer cells.
    Linear,
    /// Cosines of higher and higher degree over whole surfaces.
    Harmonic,
    /// More and more shots, each column integrated when it is first shot.
    #[cfg_attr(feature = "clap", value(skip))]
    Shots,
    /// More and more shots, all columns integrated before.
    #[cfg_attr(feature = "clap", value(skip))]
    ShotsOfAll,
}

impl RunSeries {
    /// The ways in the bases of the variational source other than polynomials.
    pub const BASES: [Self; 3] = [Self::Constant, Self::Linear, Self::Harmonic];

    /// Name of the way in tables.
    pub fn name(self) -> &'static str {
        match self {
            RunSeries::Uniform => "uniform",
            RunSeries::Hierarchical => "hierarchical",
            RunSeries::Hp => "hp",
            RunSeries::Sampled => "sampled",
            RunSeries::Constant => "constant",
            RunSeries::Linear => "linear",
            RunSeries::Harmonic => "harmonic",
            RunSeries::Shots => "shots",
            RunSeries::ShotsOfAll => "shots-of-all",
        }
    }
}

/// A solved discretisation with its errors.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvergenceRun {
    /// The way that it is a step of.
    pub series: RunSeries,
    /// Highest order of the bases.
    pub order: usize,
    /// Layers of graded elements.
    pub layers: usize,
    /// Number of elements.
    pub elements: usize,
    /// Number of coefficients per band.
    pub unknowns: usize,
    /// Shots, most of any band and light group, where light was shot.
    pub shots: Option<usize>,
    /// Columns of the transfers that were integrated, where light was shot.
    pub columns: Option<usize>,
    /// Terms of the kernel's quadrature rules.
    pub samples: u64,
    /// Segments tested for visibility.
    pub rays: u64,
    /// Wall time from elements to coefficients (s); of refined elements with all runs before and their
    /// estimates.
    pub seconds: f64,
    /// Relative error; None for the run that is itself the reference.
    pub error: Option<f64>,
    /// Order of convergence in the unknowns from the run before; None without one, or with equal unknowns.
    pub rate: Option<f64>,
    /// Relative error of energy against the finest uniform run; None for that run, and where the two are
    /// minima of different functionals or rounding and the accuracy of the transfers exceed it.
    pub energy: Option<f64>,
}

/// The reference that errors are measured against.
pub enum Reference<'a> {
    /// The last and finest uniform run.
    FinestRun,
    /// A function that gives the error of a solution.
    Given(&'a dyn Fn(&Solution) -> f64),
}

/// Parts of the whole work that are told.
const PARTS: usize = 1000;

/// A run to be made.
struct PlannedRun {
    series: RunSeries,
    options: Options,
    /// The accuracy that elements are refined for.
    wanted: Option<f64>,
}

/// A run that was made.
struct FinishedRun {
    outcome: Outcome,
    seconds: f64,
}

/// Solves `scene` at orders 0 to `options.order` on 0 to `options.layers.count` layers, layers slowest, and
/// then in the `other` ways.
///
/// The finished part of all runs is told, in thousandths.
///
/// # Errors
/// The first run that fails.
pub fn convergence(
    scene: &Scene,
    options: &Options,
    other: &[RunSeries],
    reference: &Reference,
    work: &Work<'_>,
) -> Result<Vec<ConvergenceRun>, Failure> {
    let plan = plan(options, other);
    let costs: Vec<f64> = plan.iter().map(PlannedRun::cost).collect();
    let all: f64 = costs.iter().sum();
    let mut made = Vec::with_capacity(plan.len());
    let mut before = 0.0;
    for (planned, cost) in plan.iter().zip(costs) {
        let furthest = AtomicUsize::new(0);
        let observe = |progress| match progress {
            Progress::Done { stage: Stage::Blocks, done, of } => {
                let done = furthest.fetch_max(done, Ordering::Relaxed).max(done);
                let part = (before + cost * (done as f64 / of.max(1) as f64).min(1.0)) / all;
                work.report_done(Stage::Runs, (PARTS as f64 * part) as usize, PARTS);
            }
            Progress::Began { .. } | Progress::Ended { .. } => work.report(progress),
            _ => {}
        };
        made.push(planned.solve(scene, &work.observed_by(&observe))?);
        before += cost;
    }
    Ok(runs(&plan, &made, reference))
}

fn plan(options: &Options, other: &[RunSeries]) -> Vec<PlannedRun> {
    let layers = |count| Layers { count, ..options.layers };
    let uniform = |options| PlannedRun { series: RunSeries::Uniform, options, wanted: None };
    let of_layers = |count| {
        (0..=options.order).map(move |order| uniform(Options { order, layers: layers(count), ..*options }))
    };
    let mut plan: Vec<PlannedRun> = (0..=options.layers.count).flat_map(of_layers).collect();
    let plain = Options { layers: layers(0), ..*options };
    let of_series = |series: RunSeries| -> Vec<PlannedRun> {
        let planned = |options, wanted| PlannedRun { series, options, wanted };
        let by_links = |eps| Options { method: LightMethod::Hierarchical, order: 0, eps, ..plain };
        let on_cells = |basis, order, cells| Options { basis, order, subdivide: Some(cells), ..plain };
        let by_cosines = |order| Options { basis: Basis::Harmonic, order, ..plain };
        let by_rays = |rays| Options { transport: Transport::Sampled, rays: Some(rays), ..plain };
        match series {
            // Shots are a study of their own.
            RunSeries::Uniform | RunSeries::Shots | RunSeries::ShotsOfAll => Vec::new(),
            RunSeries::Hierarchical => LINKS.map(|eps| planned(by_links(eps), None)).into(),
            RunSeries::Hp => WANTED.map(|wanted| planned(Options { order: 0, ..plain }, Some(wanted))).into(),
            RunSeries::Sampled => RAYS.map(|rays| planned(by_rays(rays), None)).into(),
            RunSeries::Constant => {
                CELLS.map(|cells| planned(on_cells(Basis::Constant, 0, cells), None)).into()
            }
            RunSeries::Linear => CELLS.map(|cells| planned(on_cells(Basis::Linear, 1, cells), None)).into(),
            RunSeries::Harmonic => {
                (0..=options.order).map(|order| planned(by_cosines(order), None)).collect()
            }
        }
    };
    plan.extend(other.iter().flat_map(|series| of_series(*series)));
    plan
}

impl PlannedRun {
    /// Cost of the run: about the number of pairs of basis functions, for uniform runs.
    fn cost(&self) -> f64 {
        let cells = (self.options.subdivide.unwrap_or(1) + 2 * self.options.layers.count).pow(2);
        ((cells * self.options.space.count(self.options.order)) as f64).powi(2)
    }

    fn solve(&self, scene: &Scene, work: &Work<'_>) -> Result<FinishedRun, Failure> {
        let begun = Instant::now();
        let Some(wanted) = self.wanted else {
            return Ok(FinishedRun::of(solve(scene, &self.options, work)?));
        };
        let goal = Goal::new(wanted, Aim::Gathered);
        let outcome = Solved::to_accuracy(scene.clone(), &self.options, &goal, work)?.outcome;
        Ok(FinishedRun { outcome, seconds: begun.elapsed().as_secs_f64() })
    }
}

impl FinishedRun {
    /// The run of an outcome, from elements to coefficients.
    fn of(outcome: Outcome) -> Self {
        let stages = outcome.seconds;
        let seconds = stages.elements + stages.visibility + stages.blocks + stages.direct + stages.solve;
        Self { outcome, seconds: seconds.as_secs_f64() }
    }
}

/// Solves `scene` by 0, 1, 2, 4, … `most` shots: each time anew, columns integrated when they are first shot,
/// where that can be; and by all columns, integrated once before. Errors are those of the polynomials from
/// all light by all columns, unless there is another reference.
///
/// # Errors
/// The first run that fails.
pub fn shots(
    scene: &Scene,
    options: &Options,
    most: ShotLimit,
    reference: &Reference,
    work: &Work<'_>,
) -> Result<Vec<ConvergenceRun>, Failure> {
    let of_all = Options { columns: Some(ColumnChoice::All), shots: None, ..*options };
    let mut model = Model::assemble(scene, &of_all, work)?;
    let all_light = model.solve(scene, work)?.solution;
    let error = |solution: &Solution| match reference {
        Reference::Given(error) => error(solution),
        Reference::FinestRun => distance(solution, &all_light).expect("the runs are of one scene"),
    };
    let counts: Vec<usize> =
        (0..).map(|k| (1 << k) / 2).take_while(|count| *count < most.count).chain([most.count]).collect();
    let (mut shot, mut of_all_columns) = (Vec::new(), Vec::new());
    for (done, count) in counts.iter().enumerate() {
        work.report_done(Stage::Runs, PARTS * done / counts.len(), PARTS);
        let limit = Some(ShotLimit { count: *count, ..most });
        model = model.with_shots(limit);
        let planned = |series| PlannedRun { series, options: *options, wanted: None };
        let finished = |series, outcome: Outcome| {
            let error = error(&outcome.solution);
            run(&planned(series), &FinishedRun::of(outcome), Some(error))
        };
        of_all_columns.push(finished(RunSeries::ShotsOfAll, model.solve(scene, work)?));
        if shot.len() == done {
            let outcome = solve(scene, &Options { shots: limit, columns: None, ..*options }, work)?;
            let is_lazy = outcome.shots.as_ref().is_some_and(Shots::are_lazy);
            shot.extend(is_lazy.then(|| finished(RunSeries::Shots, outcome)));
        }
    }
    Ok([shot, of_all_columns].concat())
}

fn runs(plan: &[PlannedRun], made: &[FinishedRun], reference: &Reference) -> Vec<ConvergenceRun> {
    let last = plan.iter().rposition(|planned| planned.series == RunSeries::Uniform).unwrap_or(0);
    let error = |k: usize| match reference {
        Reference::Given(error) => Some(error(&made[k].outcome.solution)),
        Reference::FinestRun if k == last => None,
        Reference::FinestRun => {
            let finest = &made[last].outcome.solution;
            Some(distance(&made[k].outcome.solution, finest).expect("the runs are of one scene"))
        }
    };
    let finest = &made[last].outcome;
    let mut runs: Vec<ConvergenceRun> = Vec::with_capacity(plan.len());
    for (k, (planned, made)) in plan.iter().zip(made).enumerate() {
        let run = run(planned, made, error(k));
        let rate = runs.last().and_then(|before| rate(before, &run));
        let energy = (k != last).then(|| energy(&made.outcome, finest)).flatten();
        runs.push(ConvergenceRun { rate, energy, ..run });
    }
    runs
}

fn run(planned: &PlannedRun, made: &FinishedRun, error: Option<f64>) -> ConvergenceRun {
    let elements = made.outcome.solution.elements();
    let orders = elements.list().iter().map(|element| element.basis.order());
    let order = match planned.series {
        RunSeries::Uniform
        | RunSeries::Constant
        | RunSeries::Linear
        | RunSeries::Harmonic
        | RunSeries::Shots
        | RunSeries::ShotsOfAll => planned.options.order,
        _ => orders.max().unwrap_or(0),
    };
    ConvergenceRun {
        series: planned.series,
        order,
        layers: planned.options.layers.count,
        elements: elements.list().len(),
        unknowns: made.outcome.unknowns,
        shots: made.outcome.shots.as_ref().map(|shots| shots.count),
        columns: made.outcome.shots.as_ref().map(|shots| shots.columns),
        samples: made.outcome.samples,
        rays: made.outcome.rays,
        seconds: made.seconds,
        error,
        rate: None,
        energy: None,
    }
}

/// The relative error of energy of an outcome against a finer one.
fn energy(outcome: &Outcome, finest: &Outcome) -> Option<f64> {
    let sum = |own: &Outcome| own.functionals.iter().map(|functional| functional.value).sum::<f64>();
    let is_of_one = |own: &Outcome| !own.choice.sampled && own.functionals.len() == finest.functionals.len();
    let comparable = outcome.split == finest.split && is_of_one(outcome) && is_of_one(finest);
    let (own, least) = (sum(outcome), sum(finest));
    (comparable && own > least && least < 0.0).then(|| ((own - least) / -least).sqrt())
}

fn rate(before: &ConvergenceRun, run: &ConvergenceRun) -> Option<f64> {
    let (old, new) = (before.error?, run.error?);
    let is_one_series = before.series == run.series && before.layers == run.layers;
    // Surfaces that state their own order may leave the unknowns as they are.
    let comparable = is_one_series && before.unknowns != run.unknowns && old > 0.0 && new > 0.0;
    comparable.then(|| (old / new).ln() / (run.unknowns as f64 / before.unknowns as f64).ln())
}
