//! Error against time of the presets, and of the ways to read a solution: the Cornell box against path tracing.
//!
//! `cargo run --release --example read_off -- [QUALITY]`: floor and back wall, 16 × 16 cell means of irradiance, pooled area-weighted
//! relative L2 over both faces and the three bands, %; the reference's own noise is 0.14 %. Samples and rays are those of the
//! transfers; solve, ready and cells are wall times of the solution, of what is tabulated, and of the cells of all faces.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::time::Instant;

use radiosity::output::grid::{Cell, grid};
use radiosity::output::quality::{Quality, Reading};
use radiosity::output::reader::{Read, Reader};
use radiosity::scene::Scene;
use radiosity::solve::{Options, Outcome, in_threads, solve};
use radiosity::visibility::Visibility;
use serde_json::Value;

/// Emission of the scene file over unit exitance, per band: π × the published values.
const PUBLISHED: [f64; 3] = [16.16, 11.04, 4.8];

fn main() {
    let only = std::env::args().nth(1);
    let scene = Scene::builtin("cornell-box").expect("the scene is built in");
    let work = || {
        println!(
            "quality  solve s read          unknowns  samples    rays  ready s  cells s  floor %  back wall %  both %"
        );
        for (name, quality) in [
            ("quick", Quality::Quick),
            ("default", Quality::Default),
            ("fine", Quality::Fine),
            ("finest", Quality::Finest),
        ] {
            if only.as_ref().is_some_and(|only| only != name) {
                continue;
            }
            let start = Instant::now();
            let options = quality.options();
            let outcome = solve(&scene, &options, &|_| {}).expect("the box can be solved");
            let solved = start.elapsed().as_secs_f64();
            let preset = quality.reading();
            let mut readings = vec![preset];
            if quality == Quality::Default && only.is_none() {
                readings.extend([Read::Basis, Read::Direct].map(|read| Reading { read, ..preset }));
            }
            for reading in readings {
                let row = read(&scene, &outcome, &options, reading);
                println!("{name:8} {solved:7.3} {row}");
            }
        }
    };
    in_threads(Options::default().threads, work).expect("threads can be started");
}

/// Times and errors of a reading, as a row of the table.
fn read(scene: &Scene, outcome: &Outcome, options: &Options, reading: Reading) -> String {
    let visibility = Visibility::new(scene, options.into());
    let start = Instant::now();
    let reader = Reader::new(&outcome.solution, &visibility, reading.read, reading.eps);
    let ready = start.elapsed().as_secs_f64();
    let cells = grid(&reader, [16, 16], reading.rates, &|_, _| {});
    let seconds = start.elapsed().as_secs_f64() - ready;
    let [floor, wall, both] = errors(scene, &cells);
    let name = format!("{:?} {},{}", reading.read, reading.rates.direct, reading.rates.indirect);
    let unknowns = outcome.solution.elements().coefficients();
    let (samples, rays) = (outcome.samples, outcome.rays);
    format!(
        "{name:16} {unknowns:5} {samples:8} {rays:7} {ready:8.3} {seconds:8.3} {floor:8.3} {wall:12.3} {both:7.3}"
    )
}

/// Of the floor, the back wall and both, in %.
fn errors(scene: &Scene, cells: &[Cell]) -> [f64; 3] {
    let text = include_str!("../tests/data/cornell_reference.json");
    let reference: Value = serde_json::from_str(text).expect("the reference is JSON");
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
