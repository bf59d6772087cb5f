//! Error against time in real rooms with path-traced points.

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use radiosity::Scene;
use radiosity::Work;
use radiosity::solve::{Options, Outcome, Transport, solve};

use crate::diagram::{self, Line};
use crate::judge::Points;

/// Rays of the rooms.
const RAYS: [u64; 4] = [100_000, 400_000, 1_600_000, 6_400_000];

/// Hierarchical radiosity with clusters, linear, on two other rooms of the same kind: scenes and (s of CPU,
/// relative L2) with RenderPark 4, the best of many settings. The classroom did not finish in 120 s.
const HIERARCHICAL: [(&str, &[(f64, f64)]); 2] = [
    ("hierarchical radiosity, office of 429 polygons", &[(17.0, 3.0e-2), (53.0, 2.1e-2)]),
    ("hierarchical radiosity, office of 319 polygons and 220 curved", &[(5.0, 4.8e-2)]),
];

/// Error against time of every room of a folder, as a table and drawn.
pub(crate) fn rooms(folder: &Path, file: &Path) -> Result<(), Box<dyn Error>> {
    println!("| room | surfaces | rays | solved in, s | told | L2 | median |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    let mut names: Vec<String> = std::fs::read_dir(folder)?
        .filter_map(|entry| {
            Some(entry.ok()?.file_name().to_str()?.strip_suffix("_reference.json")?.to_owned())
        })
        .collect();
    names.sort();
    let mut panels = Vec::new();
    for name in names {
        let (mut errors, mut medians) = (Vec::new(), Vec::new());
        let path = folder.join(format!("{name}.json"));
        let scene = radiosity::load(path.to_str().ok_or("the path is no text")?)?;
        let points = Points::read(&folder.join(format!("{name}_reference.json")))?;
        for rays in RAYS {
            let (outcome, seconds) = by_rays(&scene, rays)?;
            let sampling = outcome.sampling.ok_or("rays were asked for")?;
            let [l2, median] = points.errors(&scene, &outcome.solution);
            errors.push((seconds, l2));
            medians.push((seconds, median));
            println!(
                "| {name} | {} | {} | {seconds:.2} | {:.1} % | {:.2} % | {:.2} % |",
                scene.surfaces.len(),
                sampling.rays,
                100.0 * sampling.error.unwrap_or(f64::NAN),
                100.0 * l2,
                100.0 * median
            );
        }
        let own = [("L2 by rays", errors), ("median by rays", medians)]
            .map(|(label, places)| Line { label: label.to_owned(), places });
        let others =
            HIERARCHICAL.map(|(label, places)| Line { label: label.to_owned(), places: places.to_vec() });
        panels.push(diagram::panel(&name, "relative error", own.into_iter().chain(others)));
    }
    diagram::write(file, "errors of the irradiance at points", panels)
}

/// A solution by so many rays, and its time.
fn by_rays(scene: &Scene, rays: u64) -> Result<(Outcome, f64), Box<dyn Error>> {
    let options = Options { transport: Transport::Sampled, rays: Some(rays), ..Options::default() };
    let start = Instant::now();
    let outcome = solve(scene, &options, &Work::alone())?;
    Ok((outcome, start.elapsed().as_secs_f64()))
}
