//! A discontinuity mesh beside masks and gathered light: error of the floor's light against time and unknowns.
//!
//! `cargo run --release -p radiosity-studies --bin discontinuity_mesh` prints tables and draws
//! docs/discontinuity-mesh.svg, and the pieces of the floors in docs/discontinuity-mesh-floors.svg. Zatz
//! (1993, 5.1 and 6.2) holds his masks against a mesh that is cut along the edges of shadows, with quadratic
//! elements. Here all flat receivers are cut along the critical lines of the scene: where the planes through
//! an occluder's edge and a lamp's corner, or a lamp's edge and an occluder's corner, meet them (`critical`),
//! into convex pieces (`mesh`). Polynomials of order 2 on the pieces are the whole light; pieces are halved
//! further until none is longer than told.
//!
//! Errors are those of the floor's irradiance at 48 × 48 points off its holes, relative L2 over all bands,
//! against the finest preset gathered twice. Seconds are those of CPU, of the solution and of reading the
//! points; memory is what is reckoned before the run. No pair is carried by rays.

mod critical;
mod mesh;
mod judge;
mod ways;
mod curves;
mod floor;

use std::error::Error;
use std::io::{Write, stdout};

use judge::Judge;
use ways::Run;

/// Scenes, and the starts of the names of the surfaces that make up each occluder.
const SCENES: [(&str, &[&str]); 2] = [("occluder-box", &["panel"]), ("two-boxes", &["low-", "tall-"])];

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = stdout().lock();
    let (mut panels, mut cut) = (Vec::new(), Vec::new());
    for (name, occluders) in SCENES {
        let scene = radiosity::builtin(name)?;
        let judge = Judge::new(&scene)?;
        writeln!(out, "| {name} | | elements | unknowns | memory, MB | error, % | CPU time, s |")?;
        writeln!(out, "| --- | --- | --- | --- | --- | --- | --- |")?;
        let mut runs = Vec::new();
        for way in ways::all(&scene, occluders)? {
            let run = way.run(&judge)?;
            let Run { label, text, elements, unknowns, megabytes, error, seconds } = &run;
            writeln!(
                out,
                "| {label} | {text} | {elements} | {unknowns} | {megabytes:.0} | {:.2} | {seconds:.2} |",
                100.0 * error
            )?;
            runs.push(run);
        }
        writeln!(out)?;
        cut.push(mesh::meshed(&scene, occluders, f64::INFINITY));
        panels.push(curves::panel(name, "CPU time, s", &runs, |run| run.seconds));
        panels.push(curves::panel(name, "unknowns per band", &runs, |run| run.unknowns as f64));
    }
    floor::write("docs/discontinuity-mesh-floors.svg", &cut)?;
    curves::write("docs/discontinuity-mesh.svg", panels)
}
