//! Options of commands that integrate transfers and nothing of light: `view-factors` and `heat`.

use std::path::PathBuf;

use clap::Args;
use radiosity_reading::checkpoint::Checkpoint;
use radiosity_reading::rank_work::RanksWork;
use radiosity_request::{CheckRequest, TransferRequest};
use radiosity_scene::Scene;
use radiosity_work::ranks::Ranks;

use crate::{checkpoint::CheckpointArgs, console, loaded::remarks};

/// How transfers are integrated.
#[derive(Debug, Args)]
pub(crate) struct TransferArgs {
    #[command(flatten)]
    pub(crate) request: TransferRequest,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    #[command(flatten)]
    pub(crate) check: CheckRequest,

    /// Prints no progress and no summary
    #[arg(long, short, help_heading = "Messages")]
    pub(crate) quiet: bool,
}

impl TransferArgs {
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
        lines.extend(RanksWork::so_far(ranks, self.request.threads()).map(|work| work.to_string()));
        let checkpoint = Checkpoint::so_far(ranks);
        lines.extend(checkpoint.as_ref().map(Checkpoint::to_string));
        lines.extend(remarks(scene));
        lines.extend(findings);
        lines.extend(checkpoint.and_then(|own| own.warning()).map(|warning| warning.to_string()));
        lines.extend(written.into_iter().map(|path| format!("wrote {}", path.display())));
        console::tell(&lines, ranks);
    }
}
