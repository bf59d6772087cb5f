//! Cost and error of textures: a floor of 8 × 8 fields as one pattern against as many squares, and the time
//! of another pattern against that of the blocks.
//!
//! ```text
//! cargo run --release -p radiosity-studies --bin textures
//! ```

#![expect(clippy::print_stdout, reason = "tables for people")]

use std::error::Error;
use std::time::{Duration, Instant};

use radiosity::geom::DVec3;
use radiosity::geom::shapes::{Disk, FULL_TURN, Parallelogram};
use radiosity::scene::{Pattern, Placement};
use radiosity::solve::{Direct, Model, Transport, solve};
use radiosity::{Material, Options, Scene, SceneBuilder, SceneError, Work};

/// Fields along each side of the floor.
const FIELDS: usize = 8;

/// Reflectance of a field, row after row.
fn field(k: usize) -> f64 {
    if (k % FIELDS + k / FIELDS).is_multiple_of(2) { 0.85 } else { 0.05 }
}

fn texels(bright: f64) -> Result<Pattern, Box<dyn Error>> {
    let values = (0..FIELDS * FIELDS).map(|k| bright * field(k)).collect();
    Ok(Pattern::texels(FIELDS, vec![values], Placement::default())?)
}

/// A cube with a lamp under its ceiling, whose floor is one element or many.
fn room(squares: bool) -> Result<Scene, Box<dyn Error>> {
    let mut room = SceneBuilder::new("room", ["grey"]);
    let [x, y, z] = DVec3::AXES;
    let white = room.material("white", Material::new(vec![0.6], vec![0.0])?);
    let lamp = room.material("lamp", Material::new(vec![0.0], vec![30.0])?);
    let walls = [("x0", DVec3::ZERO, y, z), ("x1", x, z, y), ("y0", DVec3::ZERO, z, x), ("y1", y, x, z)];
    for (name, origin, edge1, edge2) in walls.into_iter().chain([("ceiling", z, y, x)]) {
        room.surface(name, Parallelogram::new(origin, edge1, edge2)?, &white);
    }
    room.surface("lamp", Disk::new(DVec3::new(0.5, 0.5, 0.9), -z, 0.15, 0.0, FULL_TURN)?, &lamp);
    if squares {
        for k in 0..FIELDS * FIELDS {
            let own = room.material(format!("field {k}"), Material::new(vec![field(k)], vec![0.0])?);
            let corner = (x * (k % FIELDS) as f64 + y * (k / FIELDS) as f64) / FIELDS as f64;
            let square = Parallelogram::new(corner, x / FIELDS as f64, y / FIELDS as f64)?;
            room.surface(format!("field {k}"), square, &own);
        }
    } else {
        let board = room.material("board", Material::black(1).with_reflectance_pattern(texels(1.0)?)?);
        room.surface("floor", Parallelogram::new(DVec3::ZERO, x, y)?, &board);
    }
    Ok(room.build()?)
}

/// Every pair by rules, none by rays.
fn exact() -> Options {
    Options { transport: Transport::Exact, ..Options::default() }
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, Duration) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed())
}

/// Mean irradiances of walls and ceiling.
fn means(scene: &Scene, order: usize) -> Result<(Vec<f64>, usize), Box<dyn Error>> {
    let outcome = solve(scene, &Options { order, ..exact() }, &Work::alone())?;
    let names = ["x0", "x1", "y0", "y1", "ceiling"];
    let mean = |name| Ok(outcome.solution.mean_irradiance(0, scene.surface_named(name)?));
    let means = names.into_iter().map(mean).collect::<Result<_, SceneError>>()?;
    Ok((means, outcome.solution.elements().coefficients()))
}

fn main() -> Result<(), Box<dyn Error>> {
    let (squares, unknowns) = means(&room(true)?, 3)?;
    println!("floor                order  coefficients  largest difference of mean irradiances");
    println!("64 squares               3  {unknowns:12}");
    for order in 0..=6 {
        let (own, unknowns) = means(&room(false)?, order)?;
        let off = own.iter().zip(&squares).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max);
        println!("one pattern          {order:5}  {unknowns:12}  {off:.1e}");
    }
    println!();
    println!("direct light  blocks     another pattern  ratio");
    for (name, direct) in [("projected", Direct::Projected), ("split", Direct::Split)] {
        let scene = room(false)?;
        let options = Options { order: 3, direct, ..exact() };
        let (model, blocks) = timed(|| Model::assemble(&scene, &options, &Work::alone()));
        let model = model?;
        let board = Material::black(1).with_reflectance_pattern(texels(0.5)?)?;
        let other = scene.with_material("board", board)?;
        let (outcome, again) = timed(|| model.solve(&other, &Work::alone()));
        outcome?;
        let ratio = again.as_secs_f64() / blocks.as_secs_f64();
        println!("{name:12}  {:8.1} ms  {:12.2} ms  {ratio:5.3}", millis(blocks), millis(again));
    }
    Ok(())
}

fn millis(time: Duration) -> f64 {
    1e3 * time.as_secs_f64()
}
