//! The error that `--accuracy` tells beside the true one: of light gathered at points, against that of much
//! finer runs.
//!
//! `cargo run --release -p radiosity-studies --bin estimates [-- SCENE...]`
//!
//! SCENE is a name of the lists (`scenes.rs`), of which the first is taken unless others are asked for, or a
//! file. Each scene is solved to several accuracies, none of which takes much more than twenty seconds of two
//! quiet cores. Its light and that of a fine run are then gathered at 2048 points, spread over the
//! surfaces by area, and the error is ‖ρ(E − E′)‖ / ‖ρ E′‖, E′ of the fine run. By cells both are gathered to
//! 1e-4; by rays with the same rays, to 5e-4, so that their noise is mostly the same. The last column is the
//! estimate over the error. The table below tells the spread of these.
//!
//! `cargo run --release -p radiosity-studies --bin estimates -- unknowns [SCENE...]` holds elements refined
//! where they bear the error against elements cut and raised alike: unknowns, seconds (without estimates for
//! the latter) and errors of both.

#![expect(clippy::print_stdout, reason = "a table for people")]

mod scenes;

use std::time::{Duration, Instant};

use radiosity::Work;
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::scene::Scene;
use radiosity::solve::gather::Gather;
use radiosity::solve::gather::ray_gather::{Beyond, RayGather};
use radiosity::solve::gather::receiver::Receiver;
use radiosity::solve::solution::Solution;
use radiosity::solve::solved::Solved;
use radiosity::solve::{Failure, Options, Transport, solve};
use radiosity::work::Deadline;
use rayon::prelude::*;

use radiosity_studies::spread::print_spread;

use scenes::{Case, Fine};

const WANTED: [f64; 5] = [3e-2, 1e-2, 3e-3, 1e-3, 3.1e-4];
const POINTS: usize = 2048;

/// Accuracy of gathering.
const BY_CELLS: f64 = 1e-4;
const BY_RAYS: f64 = 5e-4;

/// Time for a run, so long that a busy machine reaches what a quiet one does.
const LIMIT: Duration = Duration::from_secs(120);

fn main() {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    if asked.first().is_some_and(|first| first == "unknowns") {
        return unknowns(&asked[1..]);
    }
    println!("| scene | wanted | unknowns | seconds | estimate | error | ratio |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    let cases =
        if asked.is_empty() { scenes::usual() } else { asked.iter().map(|name| Case::named(name)).collect() };
    let ratios: Vec<f64> = cases.iter().flat_map(rows).collect();
    if asked.is_empty() {
        print_spread("estimate / error", ratios);
    }
}

/// Scenes of flat things whose fine runs are fine enough, unless others are asked for.
const FLAT: [&str; 3] = ["cornell-box", "two-boxes", "long box"];

fn unknowns(asked: &[String]) {
    println!("| scene | elements | unknowns | seconds | error |");
    println!("| --- | --- | --- | --- | --- |");
    let flat = FLAT.map(str::to_owned);
    for name in if asked.is_empty() { &flat } else { asked } {
        let case = Case::named(name);
        let truth = Truth::of(&case);
        for [order, cuts] in [[2, 1], [2, 2], [3, 2], [4, 2], [2, 4], [3, 4], [6, 2], [4, 4], [2, 6]] {
            let alike =
                Options { order, subdivide: Some(cuts), transport: Transport::Exact, ..Options::default() };
            let begun = Instant::now();
            let outcome = solve(&case.scene, &alike, &Work::alone()).expect("the scene can be solved");
            row(name, &format!("{cuts} × {cuts}, order {order}"), begun, &outcome.solution, &truth);
        }
        for wanted in [3e-2, 1e-2, 5e-3, 3e-3, 2e-3, 1.5e-3, 1e-3] {
            let begun = Instant::now();
            let adapted = adapted(&case, wanted);
            let solution = adapted.expect("the scene can be solved").outcome.solution;
            row(name, &format!("refined to {wanted:.1e}"), begun, &solution, &truth);
        }
    }
}

fn row(name: &str, elements: &str, begun: Instant, solution: &Solution, truth: &Truth) {
    let seconds = begun.elapsed().as_secs_f64();
    let unknowns = solution.elements().coefficients();
    println!("| {name} | {elements} | {unknowns} | {seconds:.2} | {:.2e} |", truth.error(solution));
}

/// Prints the rows of a scene, those apart that need no more unknowns than the row before; returns estimates
/// over errors.
fn rows(case: &Case) -> Vec<f64> {
    let truth = Truth::of(case);
    let (mut ratios, mut before) = (Vec::new(), 0);
    for wanted in WANTED.into_iter().filter(|wanted| *wanted >= case.finest) {
        let begun = Instant::now();
        let Solved { outcome, achieved, .. } = adapted(case, wanted).expect("the scene can be solved");
        let seconds = begun.elapsed().as_secs_f64();
        let unknowns = outcome.solution.elements().coefficients();
        if unknowns == before {
            continue;
        }
        before = unknowns;
        let error = truth.error(&outcome.solution);
        let estimate = achieved.and_then(|own| own.estimate).unwrap_or(f64::NAN);
        let mark = if achieved.is_some_and(|own| own.reached()) { "" } else { " (not reached)" };
        println!(
            "| {} | {wanted:.0e}{mark} | {unknowns} | {seconds:.2} | {estimate:.1e} | {error:.1e} | {:.2} |",
            case.name,
            estimate / error
        );
        ratios.push(estimate / error);
    }
    ratios
}

/// The case, solved to a wanted accuracy or until the time limit.
fn adapted(case: &Case, wanted: f64) -> Result<Solved, Failure> {
    let goal = case.goal(wanted);
    until_limit(|work| Solved::to_accuracy(case.scene.clone(), &options(), &goal, work))
}

/// Options as the command line has them where an accuracy is asked for.
fn options() -> Options {
    Options { order: 0, ..Options::default() }
}

/// The result of `find` with work that lasts until the time limit.
fn until_limit<T>(find: impl FnOnce(&Work<'_>) -> T) -> T {
    let deadline = Deadline::at(Some(Instant::now() + LIMIT));
    find(&Work::alone().until(&deadline))
}

/// Light of a fine run at points.
struct Truth<'a> {
    scene: &'a Scene,
    by_rays: bool,
    points: Vec<ReceiverPoint>,
    reflectances: Vec<Vec<f64>>,
    light: Vec<Vec<f64>>,
}

impl<'a> Truth<'a> {
    fn of(case: &'a Case) -> Self {
        let options = match case.fine {
            Fine::Exact { order, cuts } => Options {
                order,
                subdivide: Some(cuts),
                eps: 1e-4,
                shadow_eps: 1e-3,
                transport: Transport::Exact,
                ..Options::default()
            },
            Fine::Rays { rays, cuts } => Options {
                order: 2,
                subdivide: cuts,
                rays: Some(rays),
                transport: Transport::Sampled,
                ..Options::default()
            },
        };
        let fine = solve(&case.scene, &options, &Work::alone()).expect("the scene can be solved").solution;
        let by_rays = case.by_rays;
        let mut truth = Self {
            scene: &case.scene,
            by_rays,
            points: Vec::new(),
            reflectances: Vec::new(),
            light: Vec::new(),
        };
        truth.spread(&fine);
        truth.light = truth.gathered(&fine);
        truth
    }

    /// Points on reflecting elements, spread by area.
    fn spread(&mut self, fine: &Solution) {
        let list = fine.elements().list();
        let step = list.iter().map(|element| element.area).sum::<f64>() / POINTS as f64;
        let mut reached = 0.37 * step;
        for (index, element) in list.iter().enumerate() {
            let reflectances: Vec<f64> =
                fine.bands().iter().map(|band| band.coating.reflectance[index]).collect();
            for patch in &element.patches {
                reached += element.area / element.patches.len() as f64;
                while reached >= step {
                    reached -= step;
                    let k = (self.points.len() + 1) as f64;
                    let [s, t] = [2f64.sqrt(), 3f64.sqrt()].map(|root| (root * k).fract());
                    let node = patch.node(s, t);
                    if reflectances.iter().any(|reflectance| *reflectance > 0.0) {
                        self.points.push(ReceiverPoint::on(element.surface, node.position, node.normal));
                        self.reflectances.push(reflectances.clone());
                    }
                }
            }
        }
    }

    fn gathered(&self, solution: &Solution) -> Vec<Vec<f64>> {
        let visibility = (Options { shadow_eps: 1e-4, ..Options::default() }).visibility(self.scene);
        if self.by_rays {
            let gather = RayGather::new(solution, &visibility, BY_RAYS, Beyond::Polynomials);
            let read = |point: &ReceiverPoint| gather.read(&Receiver::Point(*point)).irradiance;
            return self.points.par_iter().map(read).collect();
        }
        let gather = Gather::new(solution, &visibility, BY_CELLS);
        self.points.par_iter().map(|point| gather.at(point)).collect()
    }

    /// ‖ρ(E − E′)‖ / ‖ρ E′‖ of a solution.
    fn error(&self, solution: &Solution) -> f64 {
        let mut squares = [0.0; 2];
        for ((own, truth), reflectances) in
            self.gathered(solution).iter().zip(&self.light).zip(&self.reflectances)
        {
            for ((own, truth), reflectance) in own.iter().zip(truth).zip(reflectances) {
                squares[0] += (reflectance * (own - truth)).powi(2);
                squares[1] += (reflectance * truth).powi(2);
            }
        }
        (squares[0] / squares[1]).sqrt()
    }
}
