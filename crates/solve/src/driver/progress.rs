//! Where the work stands.

use std::time::Duration;

/// Where the work stands.
#[derive(Clone, Copy, Debug)]
pub enum Progress {
    /// Pairs of elements integrated, and pairs in all.
    Blocks(usize, usize),
    /// Rays between elements.
    Rays {
        /// Rays sent.
        done: u64,
        /// Rays to be sent in all.
        total: u64,
        /// Estimate of the error that an earlier round left
        /// ([`Sampling::error`](super::sampling::Sampling::error)), once there is one.
        error: Option<f64>,
    },
    /// Band, iteration and relative residual of the solver.
    Solve(usize, usize, f64),
    /// Elements whose error is estimated, and elements in all.
    Estimate(usize, usize),
    /// A finished stage with its wall time; the names are those of [`Stages`](super::outcome::Stages).
    Finished(&'static str, Duration),
}
