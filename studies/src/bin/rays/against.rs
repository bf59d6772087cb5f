//! Rays against exact blocks at points of a scene.

use std::error::Error;
use std::time::Instant;

use radiosity::Work;
use radiosity::solve::{Options, Transport, solve};

use crate::judge::Points;

/// Points that are read, and rays of the truth.
const POINTS: usize = 300;
const TRUE: u64 = 100_000_000;

/// Rays of the runs that are judged.
const RAYS: [u64; 4] = [400_000, 1_600_000, 3_200_000, 6_400_000];

/// Prints what is wrong with the irradiance at points by rays, and by exact blocks of the default accuracy.
pub(crate) fn against(scene: &str) -> Result<(), Box<dyn Error>> {
    println!("| {scene} | solved in, s | L2 | median |");
    println!("| --- | --- | --- | --- |");
    let scene = radiosity::load(scene)?;
    let sampled = |rays| Options { transport: Transport::Sampled, rays: Some(rays), ..Options::default() };
    let truth = solve(&scene, &sampled(TRUE), &Work::alone())?.solution;
    let points = Points::of(&scene, &truth, POINTS);
    let exact = Options { transport: Transport::Exact, ..Options::default() };
    let runs = RAYS.map(|rays| (format!("{rays} rays"), sampled(rays)));
    for (name, options) in runs.into_iter().chain([("exact".to_owned(), exact)]) {
        let start = Instant::now();
        let outcome = solve(&scene, &options, &Work::alone())?;
        let seconds = start.elapsed().as_secs_f64();
        let [l2, median] = points.errors(&scene, &outcome.solution);
        println!("| {name} | {seconds:.1} | {:.2} % | {:.2} % |", 100.0 * l2, 100.0 * median);
    }
    Ok(())
}
