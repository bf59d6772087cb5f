//! Rays that a thread has sent, counted: forecasts reckon with them, so that they are the same on any machine.

use std::cell::Cell;

thread_local! {
    static RAYS: Cell<u64> = const { Cell::new(0) };
}

/// Counts so many rays of this thread.
pub fn count_rays(rays: u64) {
    RAYS.set(RAYS.get().wrapping_add(rays));
}

/// Does `work`, which does not go on in other threads, and returns what it makes with the rays that it counted.
pub fn with_rays<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let before = RAYS.get();
    let made = work();
    (made, RAYS.get().wrapping_sub(before))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_count_for_all_work_that_they_are_a_part_of() {
        let ((_, inner), outer) = with_rays(|| {
            count_rays(2);
            with_rays(|| count_rays(3))
        });
        assert_eq!([inner, outer], [3, 5]);
        let elsewhere = std::thread::spawn(|| with_rays(|| count_rays(7)).1);
        let ((), here) = with_rays(|| assert_eq!(elsewhere.join().ok(), Some(7)));
        assert_eq!(here, 0, "each thread counts its own");
    }
}
