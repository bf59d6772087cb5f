//! Work with a number of threads.

use radiosity_work::interruption;
use radiosity_work::ranks::Ranks;

use super::failure::Failure;

/// Runs `work` with that many threads, 0 for all that this process may use; all of them check the current
/// [interruption](radiosity_work::interruption).
///
/// # Errors
/// Threads that cannot be started.
pub fn in_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
    let threads = Ranks::alone().threads(threads);
    let current = interruption::current();
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .start_handler(move |_| interruption::set_current(current.clone()))
        .build();
    let pool = pool.map_err(|source| Failure::Threads { threads, source })?;
    Ok(pool.install(work))
}

#[cfg(test)]
mod tests {
    use std::thread::yield_now;

    use radiosity_work::interruption::{Interrupted, Interruption, check_interrupt};
    use rayon::prelude::*;

    use super::*;

    #[test]
    fn all_threads_of_a_pool_check_an_interruption() {
        let interruption = Interruption::new();
        let endless = |_: usize| -> usize {
            interruption.raise();
            loop {
                check_interrupt();
                yield_now();
            }
        };
        let work = || in_threads(3, || (0..64).into_par_iter().map(endless).sum::<usize>());
        assert!(matches!(interruption.within(work), Err(Interrupted)));
        let other =
            Interruption::new().within(|| in_threads(3, || rayon::join(check_interrupt, check_interrupt)));
        assert!(matches!(other, Ok(Ok(_))));
    }
}
