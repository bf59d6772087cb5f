//! Options of commands that integrate transfers and nothing of light: `view-factors` and `heat`.

use clap::Args;
use radiosity_request::TransferRequest;

use crate::checkpoint::CheckpointArgs;

/// How transfers are integrated.
#[derive(Debug, Args)]
pub(crate) struct TransferArgs {
    #[command(flatten)]
    pub(crate) request: TransferRequest,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    /// Prints no progress and no summary
    #[arg(long, short, help_heading = "Messages")]
    pub(crate) quiet: bool,
}
