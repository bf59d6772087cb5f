//! `radiosity solve`: the coefficients of a scene's radiosity.

use std::path::PathBuf;

use clap::Args;
use radiosity_request::{KEPT, require_all_light};
use radiosity_solve::{Outcome, Sampling};
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, words};

use crate::{
    error::CliError,
    loaded::Loaded,
    options::{PARAMETER_OR_GROUP, SceneArg},
    run::{Run, RunArgs},
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
    pub(crate) run: RunArgs,
}

/// Solves the scene and writes the coefficients.
pub(crate) fn run(args: &SolveArgs, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
    let cure =
        |name: &'static str| words("type ") + option(name) + " to render, probe or grid, with the scene";
    require_all_light(&args.run.method, KEPT, cure)?;
    let path = args.output.clone().unwrap_or_else(|| format!("{}.solution.json", loaded.scene().name).into());
    let format = SolutionFormat::of(&path);
    format.check(&path, &args.run.method.options(ranks))?;
    let output = loaded.reserve(&path, &args.run.report, ranks)?;
    let solve = if args.keep_partial { Run::keeping_parts } else { Run::alone };
    let mut run = solve(loaded, &args.run, ranks)?;
    let Outcome { converged, residual, sampling, .. } = run.solved.outcome;
    let is_late = run.work().is_late_here();
    let written = format.write(&run.solved, &path, &output)?;
    let reading = format.reading(&args.run.method, &run.solved, run.is_saved());
    run.check_solution(&reading)?;
    run.finish(Some(&written))?;
    match sampling {
        _ if !converged => Err(CliError::Partial { path, residual }),
        // Where time is limited, the summary tells it.
        Some(Sampling { rays, planned, .. }) if rays < planned && !is_late => {
            Err(CliError::Stopped { path, rays, planned })
        }
        _ => Ok(()),
    }
}
