//! What light gathered by rays is in error by, over all points or cells.

use serde::Serialize;

use crate::gather::by_rays::Deviation;

/// Standard deviations of readings by rays, relative to each.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ReadError {
    /// Root of the mean square.
    pub rms: f64,
    /// The largest.
    pub largest: f64,
    /// Number of readings of less than 2 % of the scene's mean radiosity in a band; theirs are relative to these 2 %.
    pub dark: usize,
}

impl ReadError {
    /// Of these readings; None where light was not gathered by rays.
    pub fn of(readings: impl Iterator<Item = Option<Deviation>>) -> Option<Self> {
        let deviations: Vec<Deviation> = readings.flatten().collect();
        let squares: f64 = deviations.iter().map(|deviation| deviation.relative.powi(2)).sum();
        let largest = deviations.iter().map(|deviation| deviation.relative).reduce(f64::max)?;
        let dark = deviations.iter().filter(|deviation| deviation.is_dark).count();
        Some(Self { rms: (squares / deviations.len() as f64).sqrt(), largest, dark })
    }
}
