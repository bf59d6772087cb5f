//! When columns of G are integrated for a solver that shoots.

use serde::{Deserialize, Serialize};

/// When columns of G are integrated for a solver that shoots.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum ColumnChoice {
    /// Each when it is first shot, by rules alone
    Shot,
    /// All before the first shot, as for all other solvers
    All,
}
