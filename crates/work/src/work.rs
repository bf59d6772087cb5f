//! Work, as it is handed down beside a scene and its options: who shares it, who observes it, and until when
//! it lasts.

use std::fmt;
use std::time::Duration;

use crate::deadline::Deadline;
use crate::observer::{Observer, Silent};
use crate::progress::{Progress, Stage};
use crate::ranks::Ranks;

/// The ranks that share the work, the observer of its progress, and the deadline until which it lasts.
///
/// ```
/// use radiosity_work::{Progress, Work};
///
/// let work = Work::alone().observed_by(&|progress: Progress| println!("{progress:?}"));
/// work.report(Progress::Rays { done: 10, of: 100, error: None });
/// ```
#[derive(Clone, Copy)]
pub struct Work<'a> {
    /// The ranks that share the work.
    pub ranks: &'a Ranks,
    /// The observer of its progress.
    pub observer: &'a dyn Observer,
    /// Deadline at which the work ends with the best that it has; None for no sooner than it is done.
    pub deadline: Option<&'a Deadline>,
}

/// Observers are left out.
impl fmt::Debug for Work<'_> {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { ranks, deadline, .. } = self;
        to.debug_struct("Work").field("ranks", ranks).field("deadline", deadline).finish_non_exhaustive()
    }
}

impl<'a> Work<'a> {
    /// Work of one rank, silent and without a deadline.
    pub fn alone() -> Self {
        Self::among(Ranks::alone())
    }

    /// Work of these ranks, silent and without a deadline.
    pub fn among(ranks: &'a Ranks) -> Self {
        Self { ranks, observer: &Silent, deadline: None }
    }

    /// This work, reported to `observer`.
    pub fn observed_by(self, observer: &'a dyn Observer) -> Self {
        Self { observer, ..self }
    }

    /// This work until a deadline.
    pub fn until(self, deadline: &'a Deadline) -> Self {
        Self { deadline: Some(deadline), ..self }
    }

    /// Reports to the observer how far the work is.
    pub fn report(&self, progress: Progress) {
        self.observer.report(progress);
    }

    /// Reports that `done` things of a stage are done, `of` so many.
    pub fn report_done(&self, stage: Stage, done: usize, of: usize) {
        self.report(Progress::Done { stage, done, of });
    }

    /// Does `work` as a stage. The thread that leads the work calls it, so that stages lie within each other.
    pub fn during<T>(&self, stage: Stage, work: impl FnOnce() -> T) -> T {
        self.report(Progress::Began { stage });
        let done = work();
        self.report(Progress::Ended { stage });
        done
    }

    /// Whether rays are no longer wanted, on any rank.
    pub fn is_ended(&self) -> bool {
        self.any(|deadline| deadline.is_wished() || deadline.is_past())
    }

    /// Whether the instant of the deadline has passed on any rank.
    pub fn is_late(&self) -> bool {
        self.any(Deadline::is_past)
    }

    /// Whether the instant of the deadline has passed, by the clock of this rank.
    pub fn is_late_here(&self) -> bool {
        self.deadline.is_some_and(Deadline::is_past)
    }

    /// The time until the deadline; None without an instant, and for several ranks, whose clocks differ.
    pub fn left(&self) -> Option<Duration> {
        self.deadline.filter(|_| self.ranks.are_alone())?.left()
    }

    /// Whether what would take so long ends in time on all ranks.
    pub fn fits(&self, long: Duration) -> bool {
        !self.any(|deadline| deadline.left().is_some_and(|left| left < long))
    }

    /// Whether any rank says this of its deadline; all ranks have one, or none.
    fn any(&self, says: impl Fn(&Deadline) -> bool) -> bool {
        self.deadline.is_some_and(|deadline| self.ranks.any(says(deadline)))
    }
}
