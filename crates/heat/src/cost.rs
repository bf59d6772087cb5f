//! About the seconds that a balance takes two threads, from counts of its work alone, so that what follows from them is
//! the same on any machine:
//!
//! ```text
//! k · samples + r · rays + u · iterations · unknowns² .
//! ```
//!
//! It is right within a factor of three, which is enough for a part of it to be spent.

use radiosity_solve::Outcome;

/// Seconds of a term of the kernel's rules, of a ray between two surfaces, and of a number of a matrix in an iteration.
/// Measured: sixty rooms of a second or two, and the Cornell box.
const SAMPLE: f64 = 2e-7;
const RAY: f64 = 1.5e-6;
const NUMBER: f64 = 1e-9;

/// Seconds of so many terms of the kernel's rules.
pub(super) fn seconds_of_samples(samples: f64) -> f64 {
    SAMPLE * samples
}

/// Seconds of the kernel's rules.
pub(super) fn seconds_of_pairs(outcome: &Outcome) -> f64 {
    seconds_of_samples(outcome.samples as f64)
}

/// Seconds of the whole.
pub(super) fn seconds_of_run(outcome: &Outcome) -> f64 {
    let rays = outcome.rays.max(outcome.sampling.map_or(0, |sampling| sampling.rays));
    let numbers = (outcome.unknowns as f64).powi(2) * outcome.iterations as f64;
    seconds_of_pairs(outcome) + RAY * rays as f64 + NUMBER * numbers
}
