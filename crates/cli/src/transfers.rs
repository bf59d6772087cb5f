//! Options of commands that integrate transfers and nothing of light: `view-factors` and `heat`.

use clap::Args;
use radiosity_request::{Shadows, TransferRequest};

use crate::{
    checkpoint::CheckpointArgs,
    numbers::{accuracy, threads},
    subdivide::Subdivide,
};

/// How transfers are integrated.
#[derive(Debug, Args)]
pub(crate) struct TransferArgs {
    /// Cuts each surface into K × K elements, which are summed: sharper shadows; auto looks at what the scene
    /// needs
    #[arg(long, value_name = "auto|K", default_value = "auto")]
    subdivide: Subdivide,

    /// Accuracy of each factor, relative to itself or a hundredth of the largest of its row; to the largest
    /// of its row where rays carry it
    #[arg(long, value_name = "E", default_value = "1e-3", value_parser = accuracy)]
    eps: f64,

    /// Accuracy of shadows [default: as --eps]
    #[arg(long, value_name = "E", value_parser = accuracy)]
    shadow_eps: Option<f64>,

    /// How it is found out what surfaces hide from each other
    #[arg(long, value_name = "MODE", default_value = "auto")]
    shadows: Shadows,

    /// Threads to use, all by default; results do not depend on it
    #[arg(long, value_name = "N", value_parser = threads)]
    threads: Option<usize>,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    /// Prints no progress and no summary
    #[arg(long, short, help_heading = "Messages")]
    pub(crate) quiet: bool,
}

impl TransferArgs {
    /// The request for transfers.
    pub(crate) fn request(&self) -> TransferRequest {
        TransferRequest {
            subdivide: self.subdivide.0,
            eps: self.eps,
            shadow_eps: self.shadow_eps,
            shadows: self.shadows,
            threads: self.threads,
        }
    }
}
