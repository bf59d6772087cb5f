//! Jumps of irradiance across coplanar neighbours, by order: Zatz (1993, 9) says that nothing makes them
//! continuous, and that orders 8 and 9 made the jump invisible.
//!
//! `cargo run --release -p radiosity-studies --bin joints`: the floor of two scenes in two parts, all light in
//! polynomials on whole surfaces and parts, or direct light computed at points, so that polynomials hold the
//! reflected light alone. A jump is |E⁺ − E⁻| over the larger of the two, the largest and the root of the mean
//! square along the joint; it is seen from about 1 % on.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;
use std::sync::Arc;

use radiosity::geom::DVec3;
use radiosity::geom::shapes::Polygon;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::SceneSurface;
use radiosity::solve::solution::SurfacePlace;
use radiosity::solve::{Direct, Options, Transport, solve};
use radiosity::{Scene, Work};

/// Where the parts of the floor meet (m): not in the middle, about which the scenes are symmetric.
const JOINT: f64 = 0.3;
/// Names of the parts.
const PARTS: [&str; 2] = ["west", "east"];
/// Places along the joint.
const PLACES: usize = 200;
/// Accuracy of what is recomputed at points.
const ACCURACY: f64 = 1e-3;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| scene | direct light | jump, % |{} |",
        (0..10).map(|order| format!(" N = {order}")).collect::<Vec<_>>().join(" |")
    );
    println!("| --- | --- | --- |{}", " --- |".repeat(10));
    for name in ["empty-box", "occluder-box"] {
        let scene = parted(&radiosity::builtin(name)?)?;
        for (what, direct, read) in [
            ("in the polynomials", Direct::Projected, ReadMode::Basis),
            ("at points", Direct::Split, ReadMode::Direct),
        ] {
            let jumps = (0..10).map(|order| jumps(&scene, order, direct, read));
            let jumps = jumps.collect::<Result<Vec<_>, _>>()?;
            for (measure, k) in [("largest", 0), ("mean square", 1)] {
                let cells: Vec<String> =
                    jumps.iter().map(|jump| format!(" {:.2}", 100.0 * jump[k])).collect();
                println!("| {name} | {what} | {measure} |{} |", cells.join(" |"));
            }
        }
    }
    Ok(())
}

/// The scene with its floor [0, 1]² in two parts.
fn parted(scene: &Scene) -> Result<Scene, Box<dyn Error>> {
    let mut scene = scene.clone();
    let floor = scene.surface_named("floor")?;
    let part = |name: &str, [from, to]: [f64; 2]| -> Result<SceneSurface, Box<dyn Error>> {
        let corners = [[from, 0.0], [to, 0.0], [to, 1.0], [from, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let mut part = scene.surfaces[floor].clone();
        part.name = name.to_owned();
        part.shape = Arc::new(Polygon::new(corners.to_vec(), Vec::new())?);
        Ok(part)
    };
    let (west, east) = (part(PARTS[0], [0.0, JOINT])?, part(PARTS[1], [JOINT, 1.0])?);
    scene.surfaces[floor] = west;
    scene.surfaces.push(east);
    Ok(scene)
}

/// The largest jump along the joint, and the root of the mean square.
fn jumps(scene: &Scene, order: usize, direct: Direct, read: ReadMode) -> Result<[f64; 2], Box<dyn Error>> {
    let options =
        Options { order, subdivide: Some(1), transport: Transport::Exact, direct, ..Options::default() };
    let outcome = solve(scene, &options, &Work::alone())?;
    let visibility = options.visibility(scene);
    let reader = Reader::new(&outcome.solution, &visibility, read, ACCURACY);
    let [west, east] = PARTS.map(|name| scene.surface_named(name));
    let [west, east] = [west?, east?];
    let elements = outcome.solution.elements();
    let light = |surface: usize, position: DVec3| {
        let foot = scene.surfaces[surface].shape.project(position);
        let place = SurfacePlace { surface, parameters: [foot.u, foot.v], position };
        let element = elements.of_surface(surface).start;
        reader.irradiance(element, &place, DVec3::Z).irradiance[0]
    };
    let (mut largest, mut squares) = (0.0f64, 0.0);
    for k in 0..PLACES {
        let position = DVec3::new(JOINT, (k as f64 + 0.5) / PLACES as f64, 0.0);
        let [one, other] = [west, east].map(|surface| light(surface, position));
        let jump = (one - other).abs() / one.max(other);
        (largest, squares) = (largest.max(jump), squares + jump * jump);
    }
    Ok([largest, (squares / PLACES as f64).sqrt()])
}
