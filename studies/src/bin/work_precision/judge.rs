//! Runs, timed and judged.

use cpu_time::ProcessTime;
use radiosity::Work;
use radiosity::elements::rule::UnitRule;
use radiosity::kernel::irradiance::visible_polygon::irradiance;
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Scene;
use radiosity::solve::solution::{Solution, SurfacePlace};
use radiosity::solve::studies::error_norm::distance;
use radiosity::solve::{Options, Outcome, in_threads, solve};
use radiosity_geom::DVec3;
use radiosity_test_support::data;

use crate::record::Record;
use crate::study::{Judge, Kernel, Study, Trial};

/// Emission of the Cornell box over unit exitance, per band: π × the published values.
const PUBLISHED: [f64; 3] = [16.16, 11.04, 4.8];

/// Runs shorter than this are repeated, and the shortest counts (s).
const SHORT: f64 = 0.1;
const REPEATS: usize = 3;

/// Accuracy of the shadows of a run that others are held against, in multiples of that of its transfers.
const SHADOWS: f64 = 3.0;

/// Points along each direction of a patch that is held against a closed form.
const POINTS: usize = 12;

/// Lamp of the sphere, in order about its front.
const LAMP: [DVec3; 4] = [
    DVec3::new(-2.0, -2.0, 3.0),
    DVec3::new(-2.0, 2.0, 3.0),
    DVec3::new(2.0, 2.0, 3.0),
    DVec3::new(2.0, -2.0, 3.0),
];

/// All runs of a study, told one by one as they end.
pub(crate) fn records(study: &Study, mut tell: impl FnMut(&Record)) -> Vec<Record> {
    let finest = match study.judge {
        Judge::Finest(trial) => {
            let shadow_eps = Options::default().shadow_eps.min(SHADOWS * trial.eps);
            let options = Options { shadow_eps, threads: 0, ..trial.options() };
            Some(run(&study.scene, &options).solution)
        }
        Judge::ClosedForm | Judge::PathTracing => None,
    };
    let record = |trial: &Trial| {
        let record = record(study, trial, finest.as_ref());
        tell(&record);
        record
    };
    study.trials.iter().map(record).collect()
}

fn run(scene: &Scene, options: &Options) -> Outcome {
    solve(scene, options, &Work::alone()).expect("every study can be solved")
}

fn record(study: &Study, trial: &Trial, finest: Option<&Solution>) -> Record {
    let (mut seconds, (outcome, cells)) = timed(|| result(study, trial));
    for _ in 1..if seconds < SHORT { REPEATS } else { 1 } {
        seconds = seconds.min(timed(|| result(study, trial)).0);
    }
    let error = match (study.judge, finest) {
        (Judge::Finest(_), Some(finest)) => distance(&outcome.solution, finest).expect("one scene"),
        (Judge::PathTracing, _) => from_path_tracing(&study.scene, &cells),
        (Judge::ClosedForm | Judge::Finest(_), _) => from_closed_form(&outcome.solution),
    };
    Record {
        scene: study.name.to_owned(),
        kernel: trial.kernel.name().to_owned(),
        order: trial.order,
        layers: trial.layers,
        cells: trial.cells,
        eps: trial.eps,
        unknowns: outcome.solution.elements().coefficients(),
        samples: outcome.samples,
        rays: outcome.rays,
        seconds,
        error,
    }
}

/// CPU time of the process and what it was spent on.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = ProcessTime::now();
    let result = work();
    (start.elapsed().as_secs_f64(), result)
}

/// The solution, and its cells where these are judged.
fn result(study: &Study, trial: &Trial) -> (Outcome, Vec<Cell>) {
    let options = trial.options();
    let outcome = run(&study.scene, &options);
    let cells = match study.judge {
        Judge::PathTracing => cells(&study.scene, &outcome, &options, trial.kernel),
        Judge::Finest(_) | Judge::ClosedForm => Vec::new(),
    };
    (outcome, cells)
}

fn cells(scene: &Scene, outcome: &Outcome, options: &Options, kernel: Kernel) -> Vec<Cell> {
    let visibility = options.visibility(scene);
    let read = if kernel == Kernel::Gathered { ReadMode::Gather } else { ReadMode::Basis };
    let read_all = || {
        let reader = Reader::new(&outcome.solution, &visibility, read, 1e-3);
        grid(&reader, [16, 16], Rates::default(), &Work::alone())
    };
    in_threads(1, read_all).expect("a thread can be started")
}

/// ‖E − E′‖ / ‖E′‖ over the first surface, E′ Lambert's form of the lamp.
fn from_closed_form(solution: &Solution) -> f64 {
    let elements = solution.elements();
    let rule = UnitRule::of(POINTS);
    let mut squares = [0.0; 2];
    for element in elements.of_surface(0) {
        for patch in &elements.list()[element].patches {
            for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
                let node = patch.node(s, t);
                let place = SurfacePlace {
                    surface: 0,
                    parameters: node.parameters.to_array(),
                    position: node.position,
                };
                let exact = irradiance(node.position, node.normal, &LAMP);
                let weight = ws * wt * node.area;
                squares[0] += weight * (solution.irradiance(0, element, &place) - exact).powi(2);
                squares[1] += weight * exact.powi(2);
            }
        }
    }
    (squares[0] / squares[1]).sqrt()
}

/// Relative L2 error over the cells of floor and back wall, all bands, against path tracing.
fn from_path_tracing(scene: &Scene, cells: &[Cell]) -> f64 {
    let reference = data::table("cornell_reference.json");
    let mut squares = [0.0; 2];
    for name in ["floor", "back_wall"] {
        let surface = scene.surface_named(name).expect("the surface is there");
        let table = &reference["faces"][name]["irradiance"];
        for cell in cells.iter().filter(|cell| cell.surface == surface) {
            for band in 0..3 {
                let exact = table[cell.index[0]][cell.index[1]][band].as_f64().expect("a number");
                let ours = cell.irradiance[band] / (std::f64::consts::PI * PUBLISHED[band]);
                squares[0] += cell.area * (ours - exact).powi(2);
                squares[1] += cell.area * exact.powi(2);
            }
        }
    }
    (squares[0] / squares[1]).sqrt()
}
