//! `radiosity relight`: a solution with its light groups at other factors.

use std::path::PathBuf;

use clap::Args;
use radiosity_request::{CheckRequest, MethodRequest};
use radiosity_work::ranks::Ranks;

use crate::{
    error::CliError,
    loaded::Loaded,
    options::{ReportArgs, setting},
    run::Run,
    solution_format::SolutionFormat,
};

/// Dims the light groups of a solution, or makes them brighter, without solving again
#[derive(Debug, Args)]
#[command(after_help = "\
Light groups are surfaces whose emission is dimmed together: those with the same `group = \"NAME\"` in the scene, of their own or of \
their material. A factor multiplies the emission that the scene states, whatever the factor was before: 0 is off, 1 as stated. \
Groups that are not named keep their factors, and light of surfaces without a group stays as it is.

The result is the solution of the scene with that emission; render, probe and grid read it. They take --set as well, for \
solutions and for scenes.

Examples:
  radiosity solve room.toml
  radiosity relight room.solution.json --set lamps=0.3 --set window=1.2 -o evening.json
  radiosity render room.solution.json --set lamps=0 -o night.png")]
pub(crate) struct RelightArgs {
    /// Solution, as `radiosity solve` writes it, or - for standard input
    #[arg(value_name = "SOLUTION")]
    pub(crate) solution: String,

    /// Multiplies the light of a group by a factor of 0 or more; once for each group
    #[arg(long = "set", value_name = "GROUP=FACTOR", required = true, value_parser = setting)]
    pub(crate) settings: Vec<(String, f64)>,

    /// File of the new solution: .json, or .vtu for ParaView [default: SCENE.relit.json]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) check: CheckRequest,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// Reads the solution and writes it at the new factors.
pub(crate) fn run(args: &RelightArgs, ranks: &Ranks) -> Result<(), CliError> {
    let loaded = Loaded::solved(&args.solution, &args.settings, ranks)?;
    let path = args.output.clone().unwrap_or_else(|| format!("{}.relit.json", loaded.scene().name).into());
    let output = loaded.reserve(&path, &args.report, ranks)?;
    let mut run = Run::read(loaded, args.check, &args.report, ranks)?;
    let format = SolutionFormat::of(&path);
    let written = format.write(&run.solved, &path, &output)?;
    let reading = format.reading(&MethodRequest::default(), &run.solved, run.is_saved());
    run.check_solution(&reading)?;
    run.finish(Some(&written))
}
