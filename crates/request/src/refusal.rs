//! What is refused before the work begins.

use radiosity_work::wording::Wording;

/// What was asked for and cannot be done.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct Refusal {
    /// What is wrong.
    pub message: Wording,
    /// How to mend it.
    pub cure: Wording,
}

impl Refusal {
    /// What is wrong, and how to mend it.
    pub(crate) fn new(message: impl Into<Wording>, cure: impl Into<Wording>) -> Self {
        Self { message: message.into(), cure: cure.into() }
    }
}
