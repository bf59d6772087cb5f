//! `radiosity render`: a picture of a scene.

use std::path::PathBuf;

use clap::Args;
use radiosity::scene::Scene;

use crate::cli::{
    error::CliError,
    options::{Counts, MethodArgs, ReportArgs, SceneArg, at_least_one, positive},
    output_file::OutputFile,
    progress::Progress,
};

/// Solves a scene and takes a picture through its camera
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  radiosity render cornell-box --order 5 --size 800x800 -o box.png")]
pub(crate) struct RenderArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the picture [default: SCENE.png]
    #[arg(short, long, value_name = "FILE.png")]
    pub(crate) output: Option<PathBuf>,

    /// Pixels across and down [default: as the scene's camera says]
    #[arg(long, value_name = "WxH")]
    pub(crate) size: Option<Counts>,

    /// Camera rays for each pixel
    #[arg(long, value_name = "S", default_value = "16", value_parser = at_least_one())]
    pub(crate) samples: usize,

    /// Factor on all radiances before they become colours [default: chosen for the picture]
    #[arg(long, value_name = "X", value_parser = positive)]
    pub(crate) exposure: Option<f64>,

    #[command(flatten)]
    pub(crate) method: MethodArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// Solves `scene` and writes a picture.
pub(crate) fn run(args: &RenderArgs, scene: Scene) -> Result<(), CliError> {
    let path = args.output.clone().unwrap_or_else(|| format!("{}.png", scene.name).into());
    let output = OutputFile::reserve(&path)?;
    let report = args.report.reserve()?;
    let progress = Progress::new(args.report.quiet);
    let _ = (output, report, progress);
    Err(CliError::Unwired { verb: "render" })
}
