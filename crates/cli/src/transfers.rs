//! Options of commands that integrate transfers and nothing of light: `view-factors` and `heat`.

use std::path::PathBuf;

use clap::Args;
use radiosity_reading::checkpoint::Checkpoint;
use radiosity_reading::rank_work::RanksWork;
use radiosity_request::{Shadows, TransferRequest};
use radiosity_scene::Scene;
use radiosity_work::ranks::Ranks;

use crate::{
    checkpoint::CheckpointArgs,
    console,
    loaded::remarks,
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

    /// Tells a summary on stderr, unless none is wanted: the lines `first`; how ranks shared the work, and
    /// what was done to the scene; the `findings`, and the files `written`.
    pub(crate) fn tell<'a>(
        &self,
        first: Vec<String>,
        scene: &Scene,
        findings: Vec<String>,
        written: impl IntoIterator<Item = &'a PathBuf>,
        ranks: &Ranks,
    ) {
        if self.quiet {
            return;
        }
        let mut lines = first;
        lines.extend(RanksWork::so_far(ranks, self.request().threads()).map(|work| work.to_string()));
        let checkpoint = Checkpoint::so_far(ranks);
        lines.extend(checkpoint.as_ref().map(Checkpoint::to_string));
        lines.extend(remarks(scene));
        lines.extend(findings);
        lines.extend(checkpoint.and_then(|own| own.warning()).map(|warning| warning.to_string()));
        lines.extend(written.into_iter().map(|path| format!("wrote {}", path.display())));
        console::tell(&lines, ranks);
    }
}
