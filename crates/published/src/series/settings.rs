//! Length and accuracy of a series.

use super::error::SeriesError;

/// Length and accuracy of a series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// N, the highest power of p.
    pub orders: usize,
    /// Largest error of an entry, relative to the largest entry at the centre of the expansion, from 1e-15 to
    /// below 1: half of it for the rules, half for the powers left out.
    pub tolerance: f64,
}

/// Most of their distance that two elements may approach each other within one expansion. The series
/// converges up to all of it: nearer to that the orders that are left out grow, and the bound of their sum is
/// useless.
const MOST_APPROACH: f64 = 0.5;

impl Settings {
    /// Refuses a tolerance out of range.
    pub(crate) fn checked(&self) -> Result<(), SeriesError> {
        let Self { tolerance, .. } = *self;
        if (1e-15..1.0).contains(&tolerance) { Ok(()) } else { Err(SeriesError::Tolerance { tolerance }) }
    }

    /// About the displacement over the distance to which the series holds: C_n⁽²⁾ is about (n + 1)/2 where
    /// the motion is across, so that the first term left out is (N + 2)/2 · h^{N+1} = tolerance/2. The rules
    /// have points for it.
    pub(crate) fn reach(&self) -> f64 {
        let first = self.orders as f64 + 1.0;
        (self.tolerance / (first + 1.0)).powf(1.0 / first).min(MOST_APPROACH)
    }
}
