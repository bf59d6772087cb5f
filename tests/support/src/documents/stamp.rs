//! Where and when the figures of a place were made.

use std::fmt::{Display, Formatter, Result};

/// The commit, the day and the machine of a run.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Stamp {
    /// The commit, and whether sources had changed since.
    pub commit: String,
    /// The day, as `2026-11-27`.
    pub day: String,
    /// Its cores, as `2 × Intel Xeon Processor`.
    pub machine: String,
}

/// How a line with a stamp begins.
const BEGINNING: &str = "*Made ";

impl Display for Stamp {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self { commit, day, machine } = self;
        write!(f, "{BEGINNING}at {commit}, {day}, on {machine}.*")
    }
}

/// Whether a line is a stamp.
pub fn is_stamp(line: &str) -> bool {
    let line = line.trim();
    line.starts_with(BEGINNING) && line.ends_with('*')
}
