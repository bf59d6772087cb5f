//! Where the work stands.

use std::time::Duration;

/// Where the work stands.
#[derive(Clone, Copy, Debug)]
pub enum Progress {
    /// Pairs of elements integrated, and pairs in all.
    Blocks(usize, usize),
    /// Rays sent, and rays in all.
    Rays(u64, u64),
    /// Band, iteration and relative residual of the solver.
    Solve(usize, usize, f64),
    /// Elements whose error is estimated, and elements in all.
    Estimate(usize, usize),
    /// A finished stage with its wall time; the names are those of [`Stages`](super::outcome::Stages).
    Finished(&'static str, Duration),
}
