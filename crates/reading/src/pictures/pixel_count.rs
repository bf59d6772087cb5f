//! A count of the pixels that are done in one stage, reported to the observer of the work.

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_work::{Stage, Work};

/// Pixels between two reports: one takes a microsecond. Chosen.
const OFTEN: usize = 1024;

/// Counts pixels, from any thread.
pub(crate) struct PixelCount<'a> {
    done: AtomicUsize,
    total: usize,
    stage: Stage,
    work: &'a Work<'a>,
}

impl<'a> PixelCount<'a> {
    /// A count of `total` pixels in a stage of this work, none of which is done.
    pub(crate) fn new(total: usize, stage: Stage, work: &'a Work<'a>) -> Self {
        Self { done: AtomicUsize::new(0), total, stage, work }
    }

    /// Counts one more pixel as done.
    pub(crate) fn add(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        if done.is_multiple_of(OFTEN) || done == self.total {
            self.work.report_done(self.stage, done, self.total);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;

    use radiosity_work::Progress;

    use super::*;

    #[test]
    fn the_last_is_told_and_the_count_never_exceeds_all() {
        let reports = Mutex::new(Vec::new());
        let observe = |progress| {
            let Progress::Done { stage: Stage::Picture, done, of } = progress else { panic!("{progress:?}") };
            reports.lock().expect("no panic").push((done, of));
        };
        let work = Work::alone().observed_by(&observe);
        let pixel_count = PixelCount::new(2 * OFTEN + 7, Stage::Picture, &work);
        (0..2 * OFTEN + 7).for_each(|_| pixel_count.add());
        let all = 2 * OFTEN + 7;
        assert_eq!(*reports.lock().expect("no panic"), [(OFTEN, all), (2 * OFTEN, all), (all, all)]);
    }
}
