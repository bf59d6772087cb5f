//! About the seconds that the transfers and systems of a run take two threads, from counts of work alone, so that what
//! follows from them is the same on any machine:
//!
//! ```text
//! k · samples + r · rays + u · iterations · bands · unknowns² .
//! ```
//!
//! It is right within a factor of three, which is enough for a part of it to be spent. What is told before
//! (`super::forecast`) knows that rays take longer among many surfaces.

/// Seconds of a term of the kernel's rules with what hides it, of a ray with the exact pairs beside it, and of a number
/// of a matrix in an iteration. Measured: some seventy rooms of 0.04 to 2 s, and the Cornell box.
const SAMPLE: f64 = 1e-7;
const RAY: f64 = 5e-7;
pub(super) const NUMBER: f64 = 1e-9;

/// Seconds of so many terms of the kernel's rules.
pub fn seconds_of_samples(samples: f64) -> f64 {
    SAMPLE * samples
}

/// Seconds of so many rays.
pub(crate) fn seconds_of_rays(rays: f64) -> f64 {
    RAY * rays
}
