//! `radiosity convergence`: how the error of a scene's radiosity falls with order, layers, unknowns and time.

use std::io::{Write, stdout};
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use radiosity::convergence::{Reference, Run, convergence};

use crate::cli::{
    error::CliError,
    options::{MethodArgs, SceneArg},
    progress::Progress,
    run::{Loaded, options},
    table::Table,
};

/// Solves a scene at orders 0 to --max-order, prints the errors and draws them
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  radiosity convergence empty-box --max-order 6 --layers 2 -o empty-box.svg",
    mut_arg("order", |order| order.long("max-order").value_name("N").default_value("6")
        .help("Highest degree of the polynomials: the scene is solved at 0, 1, … N")),
    mut_arg("layers", |layers| layers.help("Most layers: every order is run on 0, 1, … L of them")),
    mut_arg("accuracy", |accuracy| accuracy.hide(true)),
)]
pub(crate) struct ConvergenceArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the drawing, .svg or .png [default: SCENE.svg]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// How the table on standard output is written
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub(crate) format: Format,

    /// Prints no progress
    #[arg(long, short)]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) method: MethodArgs,
}

/// `--format` of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Columns for eyes
    Text,
    /// Comma-separated values with every digit
    Csv,
}

/// Solves the scene again and again, prints the table and draws the errors.
pub(crate) fn run(args: &ConvergenceArgs, loaded: &Loaded) -> Result<(), CliError> {
    let progress = Progress::new(args.quiet);
    let advance = |part: f64| progress.show("runs", (1000.0 * part) as usize, 1000);
    let runs = convergence(&loaded.scene, &options(&args.method), &Reference::FinestRun, &advance)?;
    drop(progress);
    let table = match args.format {
        Format::Text => text(&runs),
        Format::Csv => csv(&runs),
    };
    Ok(stdout().write_all(table.as_bytes())?)
}

const HEADER: [&str; 9] =
    ["order", "layers", "elements", "unknowns", "samples", "rays", "seconds", "error", "rate"];

fn text(runs: &[Run]) -> String {
    let mut table = Table::new(HEADER);
    for run in runs {
        let number = |x: Option<f64>, show: fn(f64) -> String| x.map_or_else(|| "–".to_owned(), show);
        table.row([
            run.order.to_string(),
            run.layers.to_string(),
            run.elements.to_string(),
            run.unknowns.to_string(),
            run.samples.to_string(),
            run.rays.to_string(),
            format!("{:.4}", run.seconds),
            number(run.error, |error| format!("{error:.3e}")),
            number(run.rate, |rate| format!("{rate:.2}")),
        ]);
    }
    table.to_string()
}

fn csv(runs: &[Run]) -> String {
    let mut table = HEADER.join(",") + "\n";
    for run in runs {
        let Run { order, layers, elements, unknowns, samples, rays, seconds, .. } = run;
        let [error, rate] = [run.error, run.rate].map(|x| x.map_or_else(String::new, |x| x.to_string()));
        table +=
            &format!("{order},{layers},{elements},{unknowns},{samples},{rays},{seconds},{error},{rate}\n");
    }
    table
}
