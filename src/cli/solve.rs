//! `radiosity solve`: the coefficients of a scene's radiosity.

use std::path::PathBuf;

use clap::Args;
use radiosity::scene::Scene;

use crate::cli::{
    error::CliError,
    options::{MethodArgs, ReportArgs, SceneArg},
    output_file::OutputFile,
    progress::Progress,
};

/// Solves a scene and writes the coefficients of its radiosity
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  radiosity solve cornell-box --order 5 -o box.solution.json --report box.json"
)]
pub(crate) struct SolveArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the solution [default: SCENE.solution.json]
    #[arg(short, long, value_name = "FILE.json")]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) method: MethodArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// Solves `scene` and writes the coefficients.
pub(crate) fn run(args: &SolveArgs, scene: Scene) -> Result<(), CliError> {
    let path = args.output.clone().unwrap_or_else(|| format!("{}.solution.json", scene.name).into());
    let output = OutputFile::reserve(&path)?;
    let report = args.report.reserve()?;
    let progress = Progress::new(args.report.quiet);
    let _ = (output, report, progress);
    Err(CliError::Unwired { verb: "solve" })
}
