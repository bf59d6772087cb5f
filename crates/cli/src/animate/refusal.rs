//! Refusals of names of films and pictures.

use std::path::Path;

use crate::error::CliError;

/// Refuses what a name as typed asks for.
pub(super) fn refused(name: &Path, message: &str, cure: &str) -> CliError {
    CliError::refused(format!("{}: {message}", name.display()), cure)
}
