//! Time and memory against the number of surfaces.

use std::error::Error;
use std::time::Instant;

use radiosity::Work;
use radiosity::solve::solved::Solved;
use radiosity::solve::studies::adaptation::{Aim, Goal};
use radiosity::solve::{Options, Transport};

use radiosity_studies::boxes::room;
use radiosity_studies::memory::most_memory;

/// Boxes along the three edges of the halls: about 10³, 10⁴ and 10⁵ surfaces.
const HALLS: [[usize; 3]; 3] = [[7, 6, 4], [17, 14, 7], [37, 30, 15]];

/// Error that halls are solved to.
const WANTED: f64 = 3e-2;

/// Prints how time and memory grow with the number of surfaces.
pub(crate) fn halls() -> Result<(), Box<dyn Error>> {
    println!("| surfaces | rays | solved in, s | MB at most | told |");
    println!("| --- | --- | --- | ---: | --- |");
    for grid in HALLS {
        let scene = room(grid);
        let options = Options { transport: Transport::Sampled, ..Options::default() };
        let start = Instant::now();
        let goal = Goal::new(WANTED, Aim::Solution);
        let adapted = Solved::to_accuracy(scene, &options, &goal, &Work::alone())?;
        let seconds = start.elapsed().as_secs_f64();
        let sampling = adapted.outcome.sampling.ok_or("rays were asked for")?;
        println!(
            "| {} | {} | {seconds:.1} | {:.0} | {:.1} % |",
            adapted.scene.surfaces.len(),
            sampling.rays,
            most_memory(),
            100.0 * sampling.error.unwrap_or(f64::NAN)
        );
    }
    Ok(())
}
