//! What results will need, before the work.

use crate::cli::error::CliError;
use crate::cli::memory::usable;
use crate::cli::options::MethodArgs;

/// Refuses to begin on results of so many bytes where there is no room for them; `what` they are, and the option that
/// asks for less.
pub(crate) fn require(needed: u64, method: &MethodArgs, [what, option]: [&str; 2]) -> Result<(), CliError> {
    match method.memory.or_else(usable) {
        Some(allowed) if allowed < needed => Err(CliError::Refused {
            message: format!(
                "not enough memory: {what} need about {:.0} MB, {:.0} MB allowed",
                needed as f64 / 1e6,
                allowed as f64 / 1e6
            ),
            cure: format!("ask for fewer with {option}, or allow more with --memory"),
        }),
        _ => Ok(()),
    }
}
