//! `radiosity solve`: the coefficients of a scene's radiosity.

use std::path::PathBuf;

use clap::Args;
use radiosity_request::MethodRequest;
use radiosity_request::{KEPT, require_all_bounces};
use radiosity_solve::{Options, Outcome, Sampling};
use radiosity_work::ranks::Ranks;
use radiosity_work::{Deadline, Work};

use crate::{
    checkpoint::CheckpointArgs,
    error::CliError,
    interrupt,
    options::{PARAMETER_OR_GROUP, ReportArgs, SceneArg},
    progress::Progress,
    run::{Loaded, Run, options},
    solution_format::SolutionFormat,
};

/// Solves a scene and writes the coefficients of its radiosity
#[derive(Debug, Args)]
#[command(
    mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)),
    after_help = "Examples:\n  radiosity solve cornell-box --order 5 -o box.solution.json --report box.json\n  radiosity solve cornell-box -o box.vtu"
)]
pub(crate) struct SolveArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the solution: .json, which other verbs read, or .vtu, cells of VTK for ParaView [default:
    /// SCENE.solution.json]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Writes the best there is where the solver does not converge, or where Ctrl-C ends the rays, and still
    /// fails
    #[arg(long)]
    pub(crate) keep_partial: bool,

    #[command(flatten)]
    pub(crate) method: MethodRequest,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// Solves the scene and writes the coefficients.
pub(crate) fn run(args: &SolveArgs, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
    require_all_bounces(&args.method, KEPT, "type --bounces to render, probe or grid, with the scene")?;
    let path = args.output.clone().unwrap_or_else(|| format!("{}.solution.json", loaded.scene.name).into());
    let format = SolutionFormat::of(&path);
    format.check(&path, &options(&args.method, ranks))?;
    let output = loaded.reserve(&path, &args.report, ranks)?;
    let (progress, limit) = (Progress::of(&args.report, ranks), args.method.ends_at());
    let hard = limit.map(|at| Deadline::at(Some(at)));
    let deadline = if args.keep_partial { Some(interrupt::soften(limit)) } else { hard.as_ref() };
    let work = Work { ranks, observer: &progress, deadline };
    let options = Options { keep_partial: args.keep_partial, ..options(&args.method, ranks) };
    let run = Run::with_options(loaded, &args.method, options, &args.report, &work)?;
    let Outcome { converged, residual, sampling, .. } = run.solved.outcome;
    let written = format.write(&run.solved, &path, &output)?;
    run.finish(progress, Some(&written))?;
    match sampling {
        _ if !converged => Err(CliError::Partial { path, residual }),
        Some(Sampling { rays, planned, .. }) if rays < planned => {
            Err(CliError::Stopped { path, rays, planned })
        }
        _ => Ok(()),
    }
}
