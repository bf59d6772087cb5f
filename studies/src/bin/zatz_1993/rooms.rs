//! Table 1: times and shots of four rooms.

use std::error::Error;
use std::io::Write;
use std::num::NonZeroUsize;

use cpu_time::ProcessTime;
use radiosity::Work;
use radiosity::published::zatz1993::masked_light::{Average, Masking};
use radiosity::published::zatz1993::transfers::{HybridReading, PaperRules};
use radiosity::scene::Scene;
use radiosity::solve::{Direct, Options, solve};
use radiosity::visibility::Shadows;
use radiosity_solvers::method::Method;

use crate::memory::megabytes;

/// Relative residual at which shooting stops; the paper does not tell its own.
const STOP: f64 = 1e-2;

/// A row of the table.
struct Room {
    figure: &'static str,
    name: &'static str,
    /// CPU time and shots.
    paper: [&'static str; 2],
    scene: Scene,
    options: Options,
}

/// Prints the table: the paper's time and shots, ours, and the memory that ours ask for.
pub(crate) fn table_1(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    writeln!(
        out,
        "| figure | room | paper: CPU time | shots | ours: CPU time, s | shots | unknowns | memory, MB | ratio of times |"
    )?;
    writeln!(out, "| --- | --- | --- | --- | --- | --- | --- | --- | --- |")?;
    for room in rooms()? {
        let Room { figure, name, paper: [time, shots], scene, options } = room;
        let start = ProcessTime::now();
        let outcome = solve(&scene, &options, &Work::alone())?;
        let seconds = start.elapsed().as_secs_f64();
        let memory = megabytes(&scene, &options);
        let unknowns = outcome.solution.elements().coefficients();
        writeln!(
            out,
            "| {figure} | {name} | {time} | {shots} | {seconds:.3} | {} | {unknowns} | {memory:.0} | {:.0} |",
            outcome.iterations,
            in_seconds(time) / seconds
        )?;
    }
    writeln!(
        out,
        "\nShots are those of all functions of a surface at once, until the relative residual is {STOP:e}; memory is \
         what is reckoned before the run, 10 MB of it for the program."
    )?;
    Ok(())
}

/// A time with its unit, in seconds.
fn in_seconds(time: &str) -> f64 {
    let (value, unit) = time.split_once(' ').expect("a number and a unit");
    let value: f64 = value.parse().expect("a number");
    if unit == "h" { 3600.0 * value } else { value }
}

fn rooms() -> Result<Vec<Room>, Box<dyn Error>> {
    let shooting = Options {
        order: 4,
        subdivide: Some(1),
        direct: Direct::Projected,
        solver: Method::named("southwell")?,
        tolerance: STOP,
        threads: 1,
        ..Options::default()
    };
    let mut empty = radiosity::builtin("occluder-box")?;
    empty.surfaces.retain(|surface| !surface.name.starts_with("panel"));
    let cells = NonZeroUsize::new(40).ok_or("no cells")?;
    let masks = Some(Masking { cells, average: Average::Plain });
    let room = |figure, name, paper, scene, options| Room { figure, name, paper, scene, options };
    Ok(vec![
        room(
            "6",
            "empty box, bright ceiling, hybrid rule of 1993",
            ["5.4 s", "7"],
            radiosity::builtin("empty-box")?,
            Options { kernel: Some(PaperRules::Hybrid(HybridReading::H1)), ..shooting },
        ),
        room("6", "empty box with a lamp", ["5.4 s", "7"], empty, shooting),
        room(
            "7",
            "one occluder",
            ["59.7 s", "33"],
            occluder(8, 4)?,
            Options { shadows: Shadows::Rays, ..shooting },
        ),
        room("7", "the same, by outlines", ["59.7 s", "33"], occluder(8, 4)?, shooting),
        room(
            "8",
            "one occluder, masks 40 × 40",
            ["42.8 s", "22"],
            occluder(8, 8)?,
            Options { masks, ..shooting },
        ),
        room(
            "12",
            "teapot",
            ["6.71 h", "53"],
            radiosity::builtin("teapot")?,
            Options { order: 6, ..shooting },
        ),
    ])
}

/// The box with a panel, with these orders of floor and lamp.
fn occluder(floor: usize, lamp: usize) -> Result<Scene, Box<dyn Error>> {
    let mut scene = radiosity::builtin("occluder-box")?;
    for (name, order) in [("floor", floor), ("lamp", lamp)] {
        let surface = scene.surface_named(name)?;
        scene.surfaces[surface].order = Some(order);
    }
    Ok(scene)
}
