//! What light gathered by rays is in error by, over all points.

use serde::Serialize;

use crate::output::probe::Reading;

/// Standard deviations of readings by rays, relative to each.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ReadError {
    /// Root of the mean square.
    pub rms: f64,
    /// The largest.
    pub largest: f64,
}

impl ReadError {
    /// Of these readings; None where light was not gathered by rays.
    pub fn of(readings: &[Reading]) -> Option<Self> {
        let errors: Vec<f64> = readings.iter().filter_map(|reading| reading.error).collect();
        let squares: f64 = errors.iter().map(|error| error * error).sum();
        let largest = errors.iter().copied().reduce(f64::max)?;
        Some(Self { rms: (squares / errors.len() as f64).sqrt(), largest })
    }
}
