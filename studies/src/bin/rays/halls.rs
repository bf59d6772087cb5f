//! Time and memory against the number of surfaces.

use std::error::Error;
use std::time::Instant;

use radiosity::solve::studies::adaptation::{Aim, Goal, adapt};
use radiosity::solve::{Options, Transport};

use radiosity_studies::boxes::room;

/// Boxes along the three edges of the halls: about 10³, 10⁴ and 10⁵ surfaces.
const HALLS: [[usize; 3]; 3] = [[7, 6, 4], [17, 14, 7], [37, 30, 15]];

/// Error that halls are solved to.
const WANTED: f64 = 3e-2;

/// How time and memory grow with the number of surfaces.
pub(crate) fn halls() -> Result<(), Box<dyn Error>> {
    println!("| surfaces | rays | solved in, s | MB at most | told |");
    println!("| --- | --- | --- | --- | --- |");
    for grid in HALLS {
        let scene = room(grid);
        let options = Options { transport: Transport::Sampled, ..Options::default() };
        let start = Instant::now();
        let adapted = adapt(&scene, &options, &Goal::new(WANTED, Aim::Solution), &|_| {})?;
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
