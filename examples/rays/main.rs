//! Error against time of the sampled transport: real rooms with path-traced points, and halls of up to 10⁵ surfaces.
//!
//! `cargo run --release --example rays -- [FOLDER]`
//!
//! FOLDER holds scenes `NAME.json` with points `NAME_reference.json`, which have a position `p`, a normal `n` and an irradiance `E`
//! each. Without it the halls are run alone. Rooms: E is read at the points by rays from the solution, and by samples of the emitters
//! themselves; "L2" is √(Σ (E − E_ref)² / Σ E_ref²), "median" that of |E − E_ref| / E_ref over points above 1 % of the mean. Halls: the
//! closed rooms of the example `sizes`, at the rays that 3 % of error are told for. Seconds are of wall time, all of the solution but
//! reading the scene; memory is the most that the process had so far (Linux).

#![expect(clippy::print_stdout, reason = "a table for people")]

#[path = "../halls/boxes.rs"]
mod boxes;
mod judge;

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use radiosity::Scene;
use radiosity::solve::{Options, Outcome, Transport, solve};
use radiosity::studies::adaptation::{Goal, adapt};

use boxes::room;
use judge::Points;

/// Rays of the rooms.
const RAYS: [u64; 4] = [100_000, 400_000, 1_600_000, 6_400_000];

/// Boxes along the three edges of the halls: about 10³, 10⁴ and 10⁵ surfaces.
const HALLS: [[usize; 3]; 3] = [[7, 6, 4], [17, 14, 7], [37, 30, 15]];

/// Error that halls are solved to.
const WANTED: f64 = 3e-2;

fn main() -> Result<(), Box<dyn Error>> {
    if let Some(folder) = std::env::args().nth(1) {
        rooms(Path::new(&folder))?;
    }
    halls()
}

/// Error against time of every room of a folder.
fn rooms(folder: &Path) -> Result<(), Box<dyn Error>> {
    println!("| room | surfaces | rays | solved in, s | told | L2 | median |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    let mut names: Vec<String> = std::fs::read_dir(folder)?
        .filter_map(|entry| {
            Some(entry.ok()?.file_name().to_str()?.strip_suffix("_reference.json")?.to_owned())
        })
        .collect();
    names.sort();
    for name in names {
        let path = folder.join(format!("{name}.json"));
        let scene = Scene::load(path.to_str().ok_or("the path is no text")?)?;
        let points = Points::read(&folder.join(format!("{name}_reference.json")))?;
        for rays in RAYS {
            let (outcome, seconds) = by_rays(&scene, rays)?;
            let sampling = outcome.sampling.ok_or("rays were asked for")?;
            let [l2, median] = points.errors(&scene, &outcome.solution);
            println!(
                "| {name} | {} | {} | {seconds:.2} | {:.1} % | {:.2} % | {:.2} % |",
                scene.surfaces.len(),
                sampling.rays,
                100.0 * sampling.error.unwrap_or(f64::NAN),
                100.0 * l2,
                100.0 * median
            );
        }
    }
    println!();
    Ok(())
}

/// A solution by so many rays, and its time.
fn by_rays(scene: &Scene, rays: u64) -> Result<(Outcome, f64), Box<dyn Error>> {
    let options = Options { transport: Transport::Sampled, rays: Some(rays), ..Options::default() };
    let start = Instant::now();
    let outcome = solve(scene, &options, &|_| {})?;
    Ok((outcome, start.elapsed().as_secs_f64()))
}

/// How time and memory grow with the number of surfaces.
fn halls() -> Result<(), Box<dyn Error>> {
    println!("| surfaces | rays | solved in, s | MB at most | told |");
    println!("| --- | --- | --- | --- | --- |");
    for grid in HALLS {
        let scene = room(grid);
        let options = Options { transport: Transport::Sampled, ..Options::default() };
        let start = Instant::now();
        let adapted = adapt(&scene, &options, Goal::new(WANTED), &|_| {})?;
        let seconds = start.elapsed().as_secs_f64();
        let sampling = adapted.outcome.sampling.ok_or("rays were asked for")?;
        println!(
            "| {} | {} | {seconds:.1} | {:.0} | {:.1} % |",
            scene.surfaces.len(),
            sampling.rays,
            most_memory(),
            100.0 * sampling.error.unwrap_or(f64::NAN)
        );
    }
    Ok(())
}

/// The most memory that this process had so far (MB); 0 where the system does not tell it.
fn most_memory() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.unwrap_or(0.0) * 1024.0 / 1e6
}
