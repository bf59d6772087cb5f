//! Work with a number of threads.

use super::failure::Failure;

/// Runs `work` with that many threads.
///
/// # Errors
/// Threads that cannot be started.
pub fn in_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|source| Failure::Threads { threads, source })?;
    Ok(pool.install(work))
}
