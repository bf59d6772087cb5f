//! Whether a run begins or goes on.

/// Whether a run begins or goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begin {
    /// In a folder without a journal.
    Anew,
    /// From the journal that the folder holds.
    Resume,
}
