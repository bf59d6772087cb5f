//! Shots: how many are asked for, and what was made of them.

use serde::Serialize;

/// Shots after which the light is taken as it is then.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShotLimit {
    /// Most shots, in each band and light group.
    pub count: usize,
    /// Whether the light of all further shots is estimated by an ambient term.
    pub ambient: bool,
}

/// Shots that were made, and columns of G integrated for them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Shots {
    /// Shots, most of any band and light group.
    pub count: usize,
    /// Columns of G that were integrated.
    pub columns: usize,
    /// Columns that there are, one for each element.
    pub of: usize,
    /// Why all columns were integrated before the first shot; None where each was when it was first shot.
    pub all_first: Option<String>,
    /// Part of the power that still waits to be shot, largest of all bands and light groups; where direct
    /// light is split off, of what surfaces reflect of its first bounce.
    pub unshot: f64,
    /// The state before the first shot and after each, of the band and light group with the most.
    pub history: Vec<Shot>,
}

/// The state after a shot.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Shot {
    /// Part of the power that waits to be shot.
    pub unshot: f64,
    /// Columns of G that were integrated so far.
    pub columns: usize,
    /// Seconds since integration began.
    pub seconds: f64,
}

impl Shots {
    /// Whether each column was integrated when it was first shot.
    pub fn are_lazy(&self) -> bool {
        self.all_first.is_none()
    }
}
