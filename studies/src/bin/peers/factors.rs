//! View factors of two unit squares.

use std::error::Error;
use std::hint::black_box;
use std::io::Write;

use radiosity::Work;
use radiosity::kernel::{Accuracy, polygon_exchange};
use radiosity::scene::Scene;
use radiosity::solve::view_factors::{Options, ViewFactors};
use radiosity_geom::DVec3;

use crate::timed;

/// Parallel at distance 1 and 0.1, and perpendicular with a common edge: closed forms, evaluated with 40
/// digits.
const EXACT: [f64; 3] = [0.199_824_895_698_387_38, 0.826_994_522_397_256_6, 0.200_043_776_075_403_15];

/// Program and relative errors with times, as measured elsewhere.
const PEERS: [[&str; 4]; 8] = [
    ["pyviewfactor 1.1.0, SA-30", "7e-16 in 0.2 ms", "4e-16 in 0.26 ms", "4.6e-7 in 0.15 ms"],
    ["pyviewfactor, GL-30 contour (deprecated)", "1e-15 in 0.07 ms", "6.6e-8 in 0.07 ms", "6.6e-2"],
    ["View3D 4.0, ε 1e-4", "5.2e-7 in 1 ms", "1.6e-4 in 1 ms", "3.9e-6 in 1 ms"],
    ["View3D 4.0, ε 1e-6 and less", "5.2e-7", "5.8e-7", "1.1e-6 (its 6 digits)"],
    ["Elmer, defaults", "1.9e-5 in 9 ms", "5.1e-2 in 16 ms", "2.9e-2 in 13 ms"],
    ["Elmer, (0.001, 0.001)", "8e-9 in 0.7–1.5 s", "5.3e-6 in 0.6 s", "1.6e-2 in 1 s"],
    ["OpenFOAM v1912, 32 × 32 faces", "3.0e-4 in 4.2 s", "1.9e-3 in 2.3 s", "2.1e-2 in 2.5 s"],
    ["OpenViewFactor SAI, 32 × 32", "9.8e-5 in 12 s", "6.2e-4 in 13 s", "2.5e-5 in 19 s"],
];

/// Calls of one exchange that are timed together.
const CALLS: u32 = 2000;

/// Prints the table.
pub(crate) fn print(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    writeln!(out, "| program | parallel, 1 | parallel, 0.1 | common edge | |")?;
    writeln!(out, "| --- | --- | --- | --- | --- |")?;
    let exchanges = [0, 1, 2].map(exchange);
    writeln!(out, "| this, `polygon_exchange` | {} | here |", exchanges.join(" | "))?;
    let scenes = [("parallel-squares", "distance", 1.0), ("parallel-squares", "distance", 0.1)];
    let scenes = [scenes[0], scenes[1], ("hinge-squares", "angle", 90.0)];
    let mut columns = Vec::new();
    for ((name, parameter, value), exact) in scenes.into_iter().zip(EXACT) {
        let scene = radiosity::language::read(&radiosity::language::source(name, &[(parameter, value)])?)?;
        columns.push(of_scene(&scene, exact)?);
    }
    writeln!(out, "| this, `ViewFactors` of a scene | {} | here |", columns.join(" | "))?;
    for [program, parallel, near, hinge] in PEERS {
        writeln!(out, "| {program} | {parallel} | {near} | {hinge} | measured elsewhere |")?;
    }
    Ok(())
}

/// Error and time of one exchange.
fn exchange(pair: usize) -> String {
    let lower = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(DVec3::from_array);
    let above = |d: f64| [[0., 0., d], [0., 1., d], [1., 1., d], [1., 0., d]].map(DVec3::from_array);
    let wall = [[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]].map(DVec3::from_array);
    let other = [above(1.0), above(0.1), wall][pair];
    let call = || polygon_exchange(black_box(&lower), black_box(&other));
    let (seconds, found) = timed(|| (1..CALLS).fold(call(), |_, _| call()));
    cell(found, EXACT[pair], seconds / f64::from(CALLS))
}

/// Error and time of the factor between the two surfaces of a scene.
fn of_scene(scene: &Scene, exact: f64) -> Result<String, Box<dyn Error>> {
    let options = Options {
        subdivide: Some(1),
        accuracy: Accuracy { eps: 1e-12, shadow_eps: 1e-3 },
        threads: 1,
        ..Options::default()
    };
    let (seconds, factors) = timed(|| ViewFactors::new(scene, &options, &Work::alone()));
    Ok(cell(factors?.factor(0, 1), exact, seconds))
}

fn cell(found: f64, exact: f64, seconds: f64) -> String {
    let error = (found / exact - 1.0).abs();
    let time =
        if seconds < 1e-4 { format!("{:.1} µs", 1e6 * seconds) } else { format!("{:.2} ms", 1e3 * seconds) };
    format!("{error:.0e} in {time}")
}
