//! Error against time of the three ways to read a solution: the Cornell box against path tracing.
//!
//! `cargo run --release --example read_off -- [ORDER] [EPS]`: floor and back wall, 16 × 16 cell means of irradiance, pooled
//! area-weighted relative L2 over both faces and the three bands, %; the reference's own noise is 0.14 %.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::time::Instant;

use radiosity::output::grid::{Cell, Rates, grid};
use radiosity::output::reader::{Read, Reader};
use radiosity::scene::Scene;
use radiosity::solve::{Options, in_threads, solve};
use radiosity::visibility::{Shadows, Visibility};
use serde_json::Value;

/// Emission of the scene file over unit exitance, per band: π × the published values.
const PUBLISHED: [f64; 3] = [16.16, 11.04, 4.8];

fn main() {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<f64>().expect("a number"));
    let order = numbers.next().unwrap_or(3.0) as usize;
    let eps = numbers.next().unwrap_or(1e-3);
    let scene = Scene::builtin("cornell-box").expect("the scene is built in");
    let options = Options { order, ..Options::default() };
    let start = Instant::now();
    let outcome = solve(&scene, &options, &|_| {}).expect("the box can be solved");
    println!("order {order}: solved in {:.2} s, {} threads", start.elapsed().as_secs_f64(), options.threads);
    let visibility = Visibility::new(&scene, Shadows::Rays(options.shadow_eps));
    println!("read         samples  ready s  cells s  floor %  back wall %  both %");
    let read = |name: &str, read: Read, rates: Rates| {
        let start = Instant::now();
        let reader = Reader::new(&outcome.solution, &visibility, read, eps);
        let ready = start.elapsed().as_secs_f64();
        let cells = grid(&reader, [16, 16], rates, &|_, _| {});
        let seconds = start.elapsed().as_secs_f64() - ready;
        let [floor, wall, both] = errors(&scene, &cells);
        println!(
            "{name:12} {:>3}, {:<3} {ready:8.3} {seconds:8.3} {floor:8.3} {wall:12.3} {both:7.3}",
            rates.direct, rates.indirect
        );
    };
    let table = || {
        read("basis", Read::Basis, Rates::default());
        read("direct", Read::Direct, Rates::default());
        for (direct, indirect) in [(8, 1), (8, 2), (8, 3)] {
            read("gather", Read::Gather, Rates { direct, indirect });
        }
    };
    in_threads(options.threads, table).expect("threads can be started");
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
