//! The cheapest runs for each error, and the time that an error takes.
//!
//! A run is on the front if none that takes as little is more accurate. Between two neighbours of the front
//! log t is linear in log e; beyond its last the line of least squares through the last three runs goes on.

use crate::record::Record;
use crate::work::Work;

/// Runs of the front that the line beyond it is fitted to.
const FITTED: usize = 3;

/// Error of the last run of a front over the least error to which the front is prolonged.
const FARTHEST: f64 = 4.0;

/// The time an error takes (s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Time {
    /// The time between runs, or that of the first run where all are more accurate.
    Reached(f64),
    /// The time beyond the most accurate run, by the line through the last runs.
    Extrapolated(f64),
    /// So far beyond it that all there is to tell is its time.
    MoreThan(f64),
}

/// The runs of a front, rising in work, falling in error.
#[derive(Clone, Debug)]
pub(crate) struct Front<'a>(Vec<&'a Record>);

impl<'a> Front<'a> {
    /// The front of some runs by one measure of work.
    pub(crate) fn of(records: impl Iterator<Item = &'a Record>, work: Work) -> Self {
        let mut sorted: Vec<&Record> = records.filter(|record| record.error > 0.0).collect();
        sorted.sort_by(|a, b| work.of(a).total_cmp(&work.of(b)).then(a.error.total_cmp(&b.error)));
        let mut kept: Vec<&Record> = Vec::new();
        for record in sorted {
            if kept.last().is_none_or(|last| record.error < last.error) {
                kept.push(record);
            }
        }
        Self(kept)
    }

    /// The runs, rising in work.
    pub(crate) fn runs(&self) -> &[&'a Record] {
        &self.0
    }

    /// The first run that is as accurate as `error`.
    pub(crate) fn first(&self, error: f64) -> Option<&'a Record> {
        self.0.iter().copied().find(|record| record.error <= error)
    }

    /// The time that `error` takes; none where there are no runs to tell.
    pub(crate) fn time(&self, error: f64) -> Option<Time> {
        let Some(next) = self.0.iter().position(|record| record.error <= error) else {
            let last = self.0.last()?;
            if error * FARTHEST < last.error {
                return Some(Time::MoreThan(last.seconds));
            }
            return self.beyond(error).map(Time::Extrapolated);
        };
        let after = self.0[next];
        if next == 0 {
            return Some(Time::Reached(after.seconds));
        }
        let before = self.0[next - 1];
        let part = (before.error / error).ln() / (before.error / after.error).ln();
        Some(Time::Reached(before.seconds * (after.seconds / before.seconds).powf(part)))
    }

    fn beyond(&self, error: f64) -> Option<f64> {
        let last = &self.0[self.0.len().saturating_sub(FITTED)..];
        let count = last.len() as f64;
        let (x, y) = (|r: &Record| r.error.ln(), |r: &Record| r.seconds.ln());
        let mean = |f: &dyn Fn(&Record) -> f64| last.iter().map(|r| f(r)).sum::<f64>() / count;
        let (x0, y0) = (mean(&x), mean(&y));
        let covariance: f64 = last.iter().map(|r| (x(r) - x0) * (y(r) - y0)).sum();
        let variance: f64 = last.iter().map(|r| (x(r) - x0).powi(2)).sum();
        (variance > 0.0).then(|| (y0 + covariance / variance * (error.ln() - x0)).exp())
    }
}
