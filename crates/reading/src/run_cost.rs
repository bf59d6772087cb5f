//! About the seconds that a run takes two threads, from counts of its work alone, so that what follows from
//! them is the same on any machine:
//!
//! ```text
//! solved:   k · samples + r · rays + u · iterations · bands · unknowns² ,
//! read:     ¼ points · seconds to gather the light of one .
//! ```
//!
//! It is right within a factor of three, which is enough for a part of it to be spent.

use radiosity_solve::gather::gather_method::seconds_to_gather;
use radiosity_solve::solved::Solved;

use crate::quality::ReadSettings;
use crate::reader::ReadMode;

/// Seconds of a term of the kernel's quadrature rules, of a ray with the exact pairs beside it, and of a
/// number of a matrix in an iteration. Measured: seven rooms and the Cornell box, 0.04 to 0.5 s.
const SAMPLE: f64 = 6.5e-8;
const RAY: f64 = 3e-7;
const NUMBER: f64 = 1e-9;

/// Part of the time of one core for each point: two threads share them, and points beside each other what is
/// around them. Measured: a grid and a picture of the Cornell box.
const SHARED: f64 = 0.25;

/// Seconds to solve the scene.
pub fn seconds_to_solve(solved: &Solved) -> f64 {
    let outcome = &solved.outcome;
    let rays = outcome.rays.max(outcome.sampling.map_or(0, |sampling| sampling.rays));
    let numbers = (outcome.unknowns as f64).powi(2) * (outcome.iterations * solved.scene.bands.len()) as f64;
    SAMPLE * outcome.samples as f64 + RAY * rays as f64 + NUMBER * numbers
}

/// Seconds to read so many points or cells with `settings`, whose points share what is found of their
/// surroundings; 0 where that takes no gathering.
pub fn seconds_to_read(solved: &Solved, settings: &ReadSettings, points: f64) -> f64 {
    match settings.read {
        ReadMode::Basis | ReadMode::Direct => 0.0,
        ReadMode::Gather | ReadMode::GatherTwice => {
            SHARED * points * seconds_to_gather(&solved.outcome.solution, solved.visibility(), settings.eps)
        }
    }
}
