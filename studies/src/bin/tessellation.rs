//! The teapot as it is, and cut into flat pieces: error of the light under it against time.
//!
//! The comparison of Zatz 1993, section 7.1: 32 bicubic patches used directly, beside 20 × 20 flat pieces for each. The
//! truth is the curved pot by 2·10⁷ rays, at 15 × 15 points of the table that it stands on.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;
use std::num::NonZeroUsize;
use std::time::Instant;

use radiosity::geom::DVec3;
use radiosity::reading::probe::{Probe, probe};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::{Notation, Scene, Source};
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::{Options, Transport};
use radiosity::{Solved, Work, language};

/// Rays of the truth, and of the runs that are judged.
const TRUE: u64 = 20_000_000;
const RAYS: [u64; 2] = [200_000, 1_000_000];

/// Flat pieces of a patch along each side.
const PIECES: [usize; 3] = [5, 10, 20];

/// Relative accuracy of light at the points of the truth, and of the runs.
const TRULY: f64 = 2e-3;
const READ: f64 = 5e-3;

/// Points along each side of the table, and half its side (metres).
const POINTS: usize = 15;
const HALF: f64 = 3.0;

/// Height of the points above the table (metres): a ray must not start below it.
const ABOVE: f64 = 1e-3;

/// A run: its size, its time, and the light that it finds.
struct Run {
    elements: usize,
    /// Solving and reading, wall time.
    seconds: f64,
    /// Irradiance of each band, point after point.
    light: Vec<f64>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let pot = radiosity::builtin("teapot")?;
    let truth = run(pot.clone(), TRUE, TRULY)?;
    println!("| pot | surfaces | rays | elements | error | s |");
    println!("| --- | --- | --- | --- | --- | --- |");
    let mut cases = vec![("curved".to_owned(), pot.clone())];
    for count in PIECES {
        cases.push((format!("{count} × {count} pieces a patch"), cut(&pot, count)?));
    }
    for (name, scene) in cases {
        for rays in RAYS {
            let surfaces = scene.surfaces.len();
            let Run { elements, seconds, light } = run(scene.clone(), rays, READ)?;
            let error = 100.0 * difference(&light, &truth.light);
            println!("| {name} | {surfaces} | {rays} | {elements} | {error:.2} % | {seconds:.1} |");
        }
    }
    Ok(())
}

/// The scene with curved surfaces cut into flat pieces.
fn cut(scene: &Scene, count: usize) -> Result<Scene, Box<dyn Error>> {
    let model = language::model(scene, NonZeroUsize::new(count))?;
    Ok(language::read(&Source::new("cut", &language::model_text(&model, Notation::Toml)))?)
}

fn run(scene: Scene, rays: u64, read: f64) -> Result<Run, Box<dyn Error>> {
    let begun = Instant::now();
    let middle = scene.middle;
    let options = Options { transport: Transport::Sampled, rays: Some(rays), ..Options::default() };
    let solved = Solved::new(scene, options, &Work::alone())?;
    let solution = &solved.outcome.solution;
    let reader = Reader::by(GatherMethod::Rays, solution, solved.visibility(), ReadMode::Gather, read);
    let place = |k: usize| HALF * (2.0 * (k as f64 + 0.5) / POINTS as f64 - 1.0);
    let point = |k: usize| DVec3::new(place(k % POINTS), place(k / POINTS), ABOVE);
    let probes: Vec<Probe> =
        (0..POINTS * POINTS).map(|k| Probe { position: point(k), normal: DVec3::Z }).collect();
    let readings = probe(&reader, &probes, middle, &Work::alone()).map_err(|(_, fault)| fault.to_string())?;
    let light = readings.into_iter().flat_map(|reading| reading.irradiance).collect();
    Ok(Run { elements: solution.elements().list().len(), seconds: begun.elapsed().as_secs_f64(), light })
}

/// Relative L2 difference.
fn difference(light: &[f64], truth: &[f64]) -> f64 {
    let squares =
        |of: &dyn Fn(f64, f64) -> f64| light.iter().zip(truth).map(|(a, b)| of(*a, *b)).sum::<f64>();
    (squares(&|a, b| (a - b).powi(2)) / squares(&|_, b| b * b)).sqrt()
}
