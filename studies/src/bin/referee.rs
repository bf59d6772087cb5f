//! The referee's noise and speed, and the seconds in which it sees an error of 1, 0.3 and 0.1 % in the L2 mean of 64
//! readings, at three standard errors.
//!
//! Its estimates have the relative error s of the L2 mean after n walks of each reading, so that a walk has the noise
//! s √n. What can be seen is [`Verdict::visible`], which falls as 1/√n.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use cpu_time::ProcessTime;
use radiosity::audit::{Effort, Estimate, Judged, Referee, Spot, Verdict};
use radiosity::language::builtins;
use radiosity::{Scene, Work, builtin, load};

/// Readings, and walks of each.
const READINGS: usize = 64;
const WALKS: f64 = 8192.0;

/// Errors to be seen.
const ERRORS: [f64; 3] = [1e-2, 3e-3, 1e-3];

/// Rooms of the folder `shared` beside the repository.
const ROOMS: [&str; 7] = [
    "scenes/mgf/soda.mgf",
    "scenes/mgf/classroom.mgf",
    "cases/lighting/horizon-window.toml",
    "cases/lighting/area-luminaires-furniture.toml",
    "cases/rooms/r2.json",
    "cases/rooms/r32.json",
    "cases/rooms/r85.json",
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut scenes: Vec<Scene> = Vec::new();
    for known in builtins() {
        let scene = builtin(known.name)?;
        scenes.extend(scene.emits().then_some(scene));
    }
    let shared = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared");
    match shared.is_dir() {
        false => println!("Without the rooms of ../shared, which is not there.\n"),
        true => {
            for room in ROOMS {
                scenes.push(load(&shared.join(room).to_string_lossy())?);
            }
        }
    }
    println!("{READINGS} readings of {WALKS} walks.\n");
    println!(
        "| scene | surfaces | noise of a walk | rays a walk | 10⁶ walks a CPU second | 1 % s | 0.3 % s | 0.1 % s |"
    );
    println!("| --- | --- | --- | --- | ---: | ---: | ---: | ---: |");
    scenes.iter().for_each(|scene| println!("{}", row(scene)));
    Ok(())
}

/// The row of a scene.
fn row(scene: &Scene) -> String {
    let (wall, cpu) = (Instant::now(), ProcessTime::now());
    let referee = Referee::of_light(scene);
    let spots: Vec<Spot> = referee.sample(READINGS, 0).into_iter().map(|point| point.spot).collect();
    let effort = Effort::of_walks(WALKS);
    let found = referee.estimates(&spots, &effort, &Work::alone());
    let (wall, cpu) = (wall.elapsed().as_secs_f64(), cpu.elapsed().as_secs_f64());
    let rays: u64 = found.iter().map(|own| own.rays).sum();
    let walks = (spots.len() as u64 * effort.walks()) as f64;
    let noise = relative_error(&found) * (effort.walks() as f64).sqrt();
    let visible = Verdict::of(&found.into_iter().map(right).collect::<Vec<_>>(), 0).visible();
    let seconds = ERRORS.map(|error| format!("{:.2}", wall * (visible / error).powi(2)));
    format!(
        "| {} | {} | {noise:.2} | {:.1} | {:.2} | {} |",
        scene.name,
        scene.surfaces.len(),
        rays as f64 / walks,
        walks / cpu * 1e-6,
        seconds.join(" | ")
    )
}

/// Relative standard error of the L2 mean.
fn relative_error(found: &[Estimate]) -> f64 {
    let all = || found.iter().flat_map(|own| &own.bands);
    let squares: f64 = all().map(|mean| mean.value * mean.value).sum();
    (all().map(|mean| mean.error * mean.error).sum::<f64>() / squares).sqrt()
}

/// A reading that is printed as it was found.
fn right(estimate: Estimate) -> Judged {
    let printed = estimate.bands.iter().map(|mean| mean.value).collect();
    Judged { printed, printed_groups: Vec::new(), estimate, size: 1.0, class: String::new() }
}
