//! `radiosity grid`: mean irradiance and radiosity over the cells of every surface.

use std::path::PathBuf;

use clap::Args;
use radiosity::scene::Scene;

use crate::cli::{
    error::CliError,
    options::{Counts, MethodArgs, ReportArgs, SceneArg},
    output_file::OutputFile,
    progress::Progress,
};

/// Solves a scene and prints means over the cells of every surface, as CSV
#[derive(Debug, Args)]
#[command(after_help = "Example:\n  radiosity grid cornell-box --cells 16x16 > cells.csv")]
pub(crate) struct GridArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// Cells of equal parameter size along u and v of every surface
    #[arg(long, value_name = "NxM", default_value = "16x16")]
    pub(crate) cells: Counts,

    /// File of the table [default: standard output]
    #[arg(short, long, value_name = "FILE.csv")]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) method: MethodArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// Solves `scene` and prints the means.
pub(crate) fn run(args: &GridArgs, scene: Scene) -> Result<(), CliError> {
    let output = args.output.as_deref().map(OutputFile::reserve).transpose()?;
    let report = args.report.reserve()?;
    let progress = Progress::new(args.report.quiet);
    let _ = (output, report, progress, scene);
    Err(CliError::Unwired { verb: "grid" })
}
