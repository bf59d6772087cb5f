//! This library beside its peers, on what the peers were measured on: an empty box, and the view factors of
//! two squares.
//!
//! `cargo run --release -p radiosity-studies --bin peers -- [box] [factors]` prints two tables as Markdown.
//! The box is the unit cube, ρ = 0.5, whose ceiling emits 1 W m⁻²; asked is the irradiance of the floor at
//! the centres of 16 × 16 cells, judged by the root of the mean square of the relative errors. The truth is a
//! finer solution of our own, on another mesh; what it says of means is printed beside what others say. Our
//! times are CPU times of one thread, from the scene in memory to the 256 numbers. The rows of the others
//! were measured once, on another day, on two shared cores: read their times as ± a factor of two.

mod empty_box;
mod factors;

use std::error::Error;
use std::io::{Write, stdout};
use std::time::Duration;

use cpu_time::ProcessTime;
use radiosity_studies::words::words;

fn main() -> Result<(), Box<dyn Error>> {
    let only = words(&["box", "factors"])?;
    let wanted = |table: &str| only.is_empty() || only.iter().any(|only| only == table);
    let mut out = stdout().lock();
    if wanted("box") {
        empty_box::print(&mut out)?;
        writeln!(out)?;
    }
    if wanted("factors") {
        factors::print(&mut out)?;
    }
    Ok(())
}

/// Work shorter than this is repeated, and the shortest time counts.
const SHORT: Duration = Duration::from_millis(300);
const REPEATS: usize = 5;

/// CPU time (s) of some work, and what came of it.
fn timed<T>(work: impl Fn() -> T) -> (f64, T) {
    let once = || {
        let start = ProcessTime::now();
        let result = work();
        (start.elapsed(), result)
    };
    let (mut shortest, result) = once();
    for _ in 1..if shortest < SHORT { REPEATS } else { 1 } {
        shortest = shortest.min(once().0);
    }
    (shortest.as_secs_f64(), result)
}
