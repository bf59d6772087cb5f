//! Refusals of requests, before the work begins.

use radiosity_work::wording::Wording;

/// A refusal of a request that cannot be met.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct Refusal {
    /// Message: the fault of the request.
    pub message: Wording,
    /// Advice on how to mend the request.
    pub cure: Wording,
}

impl Refusal {
    /// A refusal with its message and its cure.
    pub(crate) fn new(message: impl Into<Wording>, cure: impl Into<Wording>) -> Self {
        Self { message: message.into(), cure: cure.into() }
    }
}
