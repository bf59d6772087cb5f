//! The wall time of a stage.

use std::time::{Duration, Instant};

/// Runs `work`, and stores its wall time in `stage`.
pub(crate) fn timed<T>(stage: &mut Duration, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *stage = start.elapsed();
    result
}
