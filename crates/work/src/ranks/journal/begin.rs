//! The start of a run with a journal: anew, or from what the journal holds.

/// The start of a run with a journal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begin {
    /// A new run, in a folder without a journal.
    Anew,
    /// A run that goes on from the journal that the folder holds.
    Resume,
}
