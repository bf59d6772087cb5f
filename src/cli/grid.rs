//! `radiosity grid`: mean irradiance and radiosity over the cells of every surface.

use std::io::{Write, stdout};
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use radiosity::output::grid::{Cell, grid};
use radiosity::scene::Scene;

use crate::cli::{
    error::CliError,
    options::{Counts, MethodArgs, ReportArgs, SceneArg},
    output_file::OutputFile,
    progress::Progress,
    run::{Loaded, Run},
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

    /// What the means are read from
    #[arg(long, value_name = "MODE", default_value = "basis")]
    pub(crate) read: ReadMode,

    /// File of the table [default: standard output]
    #[arg(short, long, value_name = "FILE.csv")]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) method: MethodArgs,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// `--read` of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReadMode {
    /// The polynomials of the elements alone
    Basis,
}

/// Solves the scene and prints the means.
pub(crate) fn run(args: &GridArgs, loaded: Loaded) -> Result<(), CliError> {
    let output = args.output.as_deref().map(OutputFile::reserve).transpose()?;
    let progress = Progress::new(args.report.quiet);
    let run = Run::solve(loaded, &args.method, &args.report, &progress)?;
    let cells = args.cells.0.map(|count| count as usize);
    let scene = &run.solved.scene;
    let table = csv(scene, &grid(&run.solved.outcome.solution, scene.surfaces.len(), cells));
    match &output {
        Some(file) => file.write(|writer| writer.write_all(table.as_bytes()))?,
        None => stdout().write_all(table.as_bytes())?,
    }
    run.finish(progress, args.output.as_ref().map(|path| path.display().to_string()).as_deref())
}

/// `surface,i,j,E_<band>…,B_<band>…,area`, a row per cell.
fn csv(scene: &Scene, cells: &[Cell]) -> String {
    let columns = |letter: char| scene.bands.iter().map(move |band| quoted(&format!("{letter}_{band}")));
    let header = ["surface", "i", "j"].map(str::to_owned).into_iter().chain(columns('E')).chain(columns('B'));
    let mut table = header.chain(["area".to_owned()]).collect::<Vec<_>>().join(",") + "\n";
    for cell in cells {
        let name = quoted(&scene.surfaces[cell.surface].name);
        let numbers = cell.irradiance.iter().chain(&cell.radiosity).chain([&cell.area]);
        let numbers: Vec<String> = numbers.map(f64::to_string).collect();
        table += &format!("{name},{},{},{}\n", cell.index[0], cell.index[1], numbers.join(","));
    }
    table
}

/// A CSV field (RFC 4180): in quotes if it has to be.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
