//! Work with a number of threads.

use super::failure::Failure;
use crate::ranks;

/// Runs `work` with that many threads, within the current ranks.
///
/// # Errors
/// Threads that cannot be started.
pub fn in_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|source| Failure::Threads { threads, source })?;
    let ranks = ranks::current();
    Ok(pool.install(|| ranks.within(work)))
}
