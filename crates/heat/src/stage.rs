//! Where the work on a balance of heat stands.

use radiosity_solve::Progress;

/// Where the work on a balance of heat stands.
#[derive(Clone, Copy, Debug)]
pub enum Stage {
    /// The balance itself, and its conductances.
    Solution(Progress),
    /// Balances at other orders, which tell its error.
    Error(Progress),
}
