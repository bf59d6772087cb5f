//! Error against time of the presets, and of the ways to read a solution: the Cornell box against path
//! tracing.
//!
//! `cargo run --release -p radiosity-studies --bin read_off -- [WAY ...]` (quick, default, fine, finest,
//! projected, masks, masks-1993; all unless said). Floor and back wall, 16 × 16 cell means of irradiance,
//! pooled area-weighted relative L2 over both faces and the three bands, %; the reference's own noise is 0.14
//! %. Samples and rays are those of the transfers. Masks have 40 × 40 cells, and average by light or, as in
//! 1993, by area. "read" names the way to read with its rates of direct and of reflected light, points along
//! a cell's side. Times are wall times: of the solution, and of the cells of all faces with what is tabulated
//! for them.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::num::NonZeroUsize;
use std::time::Instant;

use radiosity::Work;
use radiosity::published::zatz1993::masking::{Average, Masking};
use radiosity::reading::grid::{Cell, grid};
use radiosity::reading::quality::{Quality, ReadSettings};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Scene;
use radiosity::solve::{Direct, Options, Outcome, in_threads, solve};
use radiosity_test_support::data;

use radiosity_studies::words::words;

/// Emission of the scene file over unit exitance, per band: π × the published values.
const PUBLISHED: [f64; 3] = [16.16, 11.04, 4.8];

/// A way to solve, and the ways to read that.
struct Way {
    name: &'static str,
    options: Options,
    readings: Vec<ReadSettings>,
}

fn main() -> Result<(), String> {
    let ways = ways();
    let names: Vec<&str> = ways.iter().map(|way| way.name).collect();
    let only = words(&names)?;
    let scene = radiosity::builtin("cornell-box").expect("the scene is built in");
    let work = || {
        println!(
            "| way | read | unknowns | samples | rays | floor, % | back wall, % | both, % | solve, s | cells, s | s |"
        );
        println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
        for way in ways.iter().filter(|way| only.is_empty() || only.iter().any(|only| only == way.name)) {
            let start = Instant::now();
            let outcome = solve(&scene, &way.options, &Work::alone()).expect("the box can be solved");
            let solved = start.elapsed().as_secs_f64();
            for reading in &way.readings {
                let (middle, cells) = read(&scene, &outcome, &way.options, *reading);
                println!("| {} | {middle} | {solved:.2} | {cells:.2} | {:.2} |", way.name, solved + cells);
            }
        }
    };
    in_threads(0, work).map_err(|failure| failure.to_string())
}

/// The presets, and the default with direct light as it was in 1993: in the polynomials, and times masks.
fn ways() -> Vec<Way> {
    let usual = Quality::Default.reading();
    let reads = |reads: &[ReadMode]| reads.iter().map(|read| ReadSettings { read: *read, ..usual }).collect();
    let preset = |name, quality: Quality| {
        let more = if quality == Quality::Default {
            reads(&[ReadMode::Direct, ReadMode::Basis])
        } else {
            Vec::new()
        };
        Way { name, options: quality.options(), readings: [vec![quality.reading()], more].concat() }
    };
    let cells = NonZeroUsize::new(40).expect("40 is not zero");
    let masked = |average| Options { masks: Some(Masking { cells, average }), ..Options::default() };
    vec![
        preset("quick", Quality::Quick),
        preset("default", Quality::Default),
        preset("fine", Quality::Fine),
        preset("finest", Quality::Finest),
        Way {
            name: "projected",
            options: Options { direct: Direct::Projected, ..Options::default() },
            readings: reads(&[ReadMode::Gather, ReadMode::Basis]),
        },
        Way { name: "masks", options: masked(Average::Weighted), readings: reads(&[ReadMode::Basis]) },
        Way { name: "masks-1993", options: masked(Average::Plain), readings: reads(&[ReadMode::Basis]) },
    ]
}

/// Counts and errors of a reading, as the middle of a row of the table, and its seconds.
fn read(scene: &Scene, outcome: &Outcome, options: &Options, reading: ReadSettings) -> (String, f64) {
    let visibility = options.visibility(scene);
    let start = Instant::now();
    let reader = Reader::new(&outcome.solution, &visibility, reading.read, reading.eps);
    let cells = grid(&reader, [16, 16], reading.rates, &Work::alone());
    let seconds = start.elapsed().as_secs_f64();
    let [floor, wall, both] = errors(scene, &cells);
    let name = format!("{:?} {}, {}", reading.read, reading.rates.direct, reading.rates.indirect);
    let unknowns = outcome.solution.elements().coefficients();
    let (samples, rays) = (outcome.samples, outcome.rays);
    (format!("{name} | {unknowns} | {samples} | {rays} | {floor:.3} | {wall:.3} | {both:.3}"), seconds)
}

/// Errors of the floor, the back wall and both, in %.
fn errors(scene: &Scene, cells: &[Cell]) -> [f64; 3] {
    let reference = data::table("cornell_reference.json");
    let sums = ["floor", "back_wall"].map(|name| {
        let surface = scene.surfaces.iter().position(|s| s.name == name).expect("the surface is there");
        let table = &reference["faces"][name]["irradiance"];
        let own = cells.iter().filter(|cell| cell.surface == surface);
        own.flat_map(|cell| (0..3).map(move |band| (cell, band))).fold([0.0, 0.0], |sum, (cell, band)| {
            let exact = table[cell.index[0]][cell.index[1]][band].as_f64().expect("a number");
            let ours = cell.irradiance[band] / (std::f64::consts::PI * PUBLISHED[band]);
            [sum[0] + cell.area * (ours - exact).powi(2), sum[1] + cell.area * exact * exact]
        })
    });
    let percent = |[difference, norm]: [f64; 2]| 100.0 * (difference / norm).sqrt();
    let both = [sums[0][0] + sums[1][0], sums[0][1] + sums[1][1]];
    [percent(sums[0]), percent(sums[1]), percent(both)]
}
