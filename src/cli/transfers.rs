//! Options of commands that integrate transfers and nothing of light: `view-factors` and `heat`.

use clap::Args;
use radiosity::solve::Options;
use radiosity::transport::Accuracy;

use crate::cli::{
    error::CliError,
    modes::{Shadows, Subdivide},
    numbers::{accuracy, threads},
};

/// How transfers are integrated.
#[derive(Debug, Args)]
pub(crate) struct TransferArgs {
    /// Cuts each surface into K × K elements, which are summed: sharper shadows; auto looks at what the scene needs
    #[arg(long, value_name = "auto|K", default_value = "auto")]
    pub(crate) subdivide: Subdivide,

    /// Accuracy of each factor, relative to itself or a hundredth of the largest of its row; to the largest of
    /// its row where rays carry it
    #[arg(long, value_name = "E", default_value = "1e-3", value_parser = accuracy)]
    eps: f64,

    /// Accuracy of shadows [default: as --eps]
    #[arg(long, value_name = "E", value_parser = accuracy)]
    shadow_eps: Option<f64>,

    /// How it is found out what surfaces hide from each other
    #[arg(long, value_name = "MODE", default_value = "auto")]
    pub(crate) shadows: Shadows,

    /// Threads to use, all by default; results do not depend on it
    #[arg(long, value_name = "N", value_parser = threads)]
    threads: Option<usize>,

    /// Prints no progress and no summary
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

impl TransferArgs {
    pub(crate) fn accuracy(&self) -> Accuracy {
        Accuracy { eps: self.eps, shadow_eps: self.shadow_eps.unwrap_or(self.eps) }
    }

    /// Threads to use.
    pub(crate) fn threads(&self) -> usize {
        self.threads.unwrap_or(Options::default().threads)
    }

    /// Refuses masks, which carry light.
    pub(crate) fn require_no_masks(&self) -> Result<(), CliError> {
        if self.shadows != Shadows::Mask {
            return Ok(());
        }
        Err(CliError::Refused {
            message: "--shadows mask: masks carry light of lamps, and there is none here".to_owned(),
            cure: "choose auto, exact, rays or off".to_owned(),
        })
    }
}
