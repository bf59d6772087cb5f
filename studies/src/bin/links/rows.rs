//! Row sums and errors of `--method hierarchical`, as links grow weaker.

use std::time::Instant;

use radiosity::published::hierarchy::LinkMeasure;
use radiosity::solve::solution::SurfacePlace;
use radiosity::solve::{LightMethod, Linking, Options, Outcome, solve};
use radiosity::{Scene, Work};

use crate::judge::{Judge, Point};

/// Greatest powers, and form factors, of a link.
const FALLING: [(LinkMeasure, &[f64]); 2] =
    [(LinkMeasure::Power, &[1e-2, 1e-3, 1e-4]), (LinkMeasure::FormFactor, &[1e-1, 3e-2, 1e-2])];

/// Prints a table for each scene.
pub(crate) fn rows() {
    for name in ["empty-box", "two-boxes", "teapot"] {
        let scene = radiosity::builtin(name).expect("the scene is built in");
        let judge = Judge::new(&scene, 5, 1e-3);
        println!("{name}:\n");
        println!("| measure | eps | leaves | links | row sums | lost | error | seconds |");
        println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
        for (measure, falling) in FALLING {
            falling.iter().for_each(|eps| row(&scene, measure, *eps, &judge));
        }
        println!();
    }
}

fn row(scene: &Scene, measure: LinkMeasure, eps: f64, judge: &Judge) {
    let linking = Linking { measure, least_area: 0.1 * eps, ..Linking::default() };
    let linking = if measure == LinkMeasure::Power { Linking::default() } else { linking };
    let options = Options { method: LightMethod::Hierarchical, eps, linking, ..Options::default() };
    let begun = Instant::now();
    let Outcome { solution, checks, links, .. } =
        solve(scene, &options, &Work::alone()).expect("the scene can be solved");
    let seconds = begun.elapsed().as_secs_f64();
    let error = judge.error(|Point { surface, parameters, position, .. }| {
        let element = solution.elements().at(*surface, *parameters)?;
        let place = SurfacePlace { surface: *surface, position: *position, parameters: *parameters };
        Some(solution.irradiance(0, element, &place))
    });
    println!(
        "| {measure:?} | {eps:.0e} | {} | {} | {:.3} to {:.3} | {:.2} % | {error:.1e} | {seconds:.2} |",
        solution.elements().list().len(),
        links.unwrap_or_default().links,
        checks.row_sum_min,
        checks.row_sum_max,
        100.0 * checks.energy_lost / checks.energy_in,
    );
}
