//! `radiosity convergence`: how the error of a scene's radiosity falls with order, layers, unknowns and time.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use radiosity_output::drawings::{chart::chart, drawing::Drawing};
use radiosity_output::table::{Column, Digits, Table, Value};
use radiosity_published::bases::Basis;
use radiosity_request::MethodRequest;
use radiosity_request::check_series;
use radiosity_scene::Scene;
use radiosity_solve::solution::Solution;
use radiosity_solve::solved::Solved;
use radiosity_solve::studies::convergence::{ConvergenceRun, Reference, RunSeries, convergence, shots};
use radiosity_solve::studies::error_norm::distance;
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;

use crate::{
    console,
    destination::Destination,
    error::CliError,
    format::of_kind,
    loaded::{Loaded, outside},
    options::{PARAMETER_OR_GROUP, SceneArg},
    output_file::OutputFile,
    progress::Progress,
    reference,
};

/// Solves a scene at orders 0 to --max-order, prints the errors and draws them
#[derive(Debug, Args)]
#[command(
    after_help = "Example:\n  radiosity convergence empty-box --max-order 6 --layers 2 -o empty-box.svg",
    mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)),
    mut_arg("order", |order| order.long("max-order").value_name("N").default_value("6")
        .help("Highest degree of the polynomials: the scene is solved at 0, 1, … N")),
    mut_arg("layers", |layers| layers.help("Most layers: every order is run on 0, 1, … L of them [default: 0]")),
    mut_arg("accuracy", |accuracy| accuracy.hide(true)),
    mut_arg("shots", |shots| shots.help("Instead of orders, runs 0, 1, 2, 4, … K shots at order N, with each column integrated when it is first shot and with all before, and draws the errors against shots and time")),
)]
pub(crate) struct ConvergenceArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the drawing, .svg or .png [default: SCENE.svg]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Solution file that errors are measured against [default: the finest run]
    #[arg(long, value_name = "FILE.json")]
    pub(crate) reference: Option<PathBuf>,

    /// Adds runs by other ways to those at rising orders, parted by commas: hierarchical (constants by weaker
    /// and weaker links), hp (elements refined for gathered light), sampled (more and more rays), constant,
    /// linear, harmonic (the bases of --basis)
    #[arg(long = "with", value_name = "WAYS", value_delimiter = ',', value_parser = one_of_others())]
    pub(crate) other: Vec<RunSeries>,

    /// Adds runs in the other bases of the variational source: --with constant,linear,harmonic
    #[arg(long)]
    pub(crate) bases: bool,

    /// How the table on standard output is written
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub(crate) format: Format,

    /// Prints no progress
    #[arg(long, short)]
    pub(crate) quiet: bool,

    #[command(flatten)]
    pub(crate) method: MethodRequest,
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
pub(crate) fn run(args: &ConvergenceArgs, loaded: &Loaded, ranks: &Ranks) -> Result<(), CliError> {
    let scene = loaded.scene();
    if args.method.wanted_accuracy().is_some() {
        return Err(CliError::refused(
            "convergence runs every order and chooses none",
            "leave out --accuracy, and give --max-order a number",
        ));
    }
    args.check_basis()?;
    args.check_shots()?;
    args.method.check()?;
    args.method.check_time_of_many()?;
    check_series(&args.method, &args.other_series())?;
    let path = args.output.clone().unwrap_or_else(|| format!("{}.svg", scene.name).into());
    let kind = of_kind(&path, "kind of drawing", "choose a file ending in .svg or .png")?;
    let output = args.scene.reserve(&path, ranks)?;
    let reference = args.reference.as_deref().map(|path| same_scene(path, scene, ranks)).transpose()?;
    let options = args.method.options(ranks);
    let progress = Progress::new(args.quiet, options.threads, loaded.started, ranks);
    let work = Work::among(ranks).observed_by(&progress);
    let other = args.other_series();
    let study = |reference: &Reference| match options.shots {
        None => convergence(scene, &options, &other, reference, &work),
        Some(most) => shots(scene, &options, most, reference, &work),
    };
    let runs = match &reference {
        None => study(&Reference::FinestRun)?,
        Some(Solved { outcome, .. }) => {
            let error = |solution: &Solution| {
                distance(solution, &outcome.solution).expect("surfaces and bands were compared")
            };
            study(&Reference::Given(&error))?
        }
    };
    progress.clear();
    progress.begin_output();
    draw(&drawing(args, scene, options.eps, &runs), kind, &output)?;
    let table = table(&runs);
    Destination::of(None, ranks).write(|writer| match args.format {
        Format::Text => write!(writer, "{table}"),
        Format::Csv => table.listed().csv(writer),
    })?;
    if !args.quiet {
        let written = format!("wrote {}", path.display());
        let lines = [progress.stages()].into_iter().chain(outside(scene)).chain([written]);
        let lines: Vec<String> = lines.collect();
        console::tell(&lines, ranks);
    }
    Ok(())
}

impl ConvergenceArgs {
    /// All ways other than that of rising orders.
    fn other_series(&self) -> Vec<RunSeries> {
        let bases = RunSeries::BASES.into_iter().filter(|series| self.bases && !self.other.contains(series));
        self.other.iter().copied().chain(bases).collect()
    }

    /// Refuses other ways beside shots, which are a study of one order.
    fn check_shots(&self) -> Result<(), CliError> {
        if self.method.shots.is_none() || self.other_series().is_empty() {
            return Ok(());
        }
        Err(CliError::refused(
            "--shots is a study of one order, without other ways beside it",
            "leave out --with and --bases, or --shots",
        ))
    }

    /// Refuses a basis without orders, and one of those that are all compared.
    fn check_basis(&self) -> Result<(), CliError> {
        let basis = self.method.basis.unwrap_or_default();
        let has_no_order = matches!(basis, Basis::Constant | Basis::Linear);
        if has_no_order || (self.bases && basis != Basis::Legendre) {
            let name = basis.name();
            return Err(CliError::refused(
                format!(
                    "convergence runs at rising orders, and with --bases in all bases: not --basis {name}"
                ),
                format!("take --with {name} for finer and finer cells or higher degrees, or --bases alone"),
            ));
        }
        Ok(())
    }
}

/// Parser of a way other than rising orders, which every study runs.
fn one_of_others() -> impl TypedValueParser<Value = RunSeries> {
    let others = RunSeries::value_variants().iter().filter(|series| **series != RunSeries::Uniform);
    PossibleValuesParser::new(others.map(|series| series.name()))
        .map(|name| RunSeries::from_str(&name, false).expect("the parser lets only listed names pass"))
}

/// File format of a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ChartFormat {
    Svg,
    Png,
}

/// The reference solution, of the same surfaces, bands and materials.
fn same_scene(path: &Path, scene: &Scene, ranks: &Ranks) -> Result<Solved, CliError> {
    let solved = reference::solution(path, scene, ranks)?;
    if !solved.outcome.converged {
        return Err(CliError::refused(
            format!("{}: its solver did not converge, which makes it no reference", path.display()),
            "solve it with more --max-iterations or another --solver",
        ));
    }
    if reference::same_materials(&solved.scene, scene) {
        return Ok(solved);
    }
    let message = format!("{}: it has other materials than the scene", path.display());
    Err(CliError::refused(message, "give a solution of the scene as it is"))
}

fn drawing(args: &ConvergenceArgs, scene: &Scene, eps: f64, runs: &[ConvergenceRun]) -> Drawing {
    let title = scene.title.as_ref().unwrap_or(&scene.name);
    let uniform = runs.iter().rfind(|run| run.series == RunSeries::Uniform);
    let finest = uniform.map_or_else(String::new, |run| match run.layers {
        0 => format!("order {}", run.order),
        1 => format!("order {} on 1 layer", run.order),
        layers => format!("order {} on {layers} layers", run.order),
    });
    let is_by_shots = args.method.shots.is_some();
    let against = match &args.reference {
        None if is_by_shots => "all light by all columns".to_owned(),
        None => format!("the finest run, {finest}"),
        Some(path) => path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
    };
    let accuracy = match args.method.kernel.unwrap_or_default().rules() {
        Some(_) => "the rules of 1993".to_owned(),
        None => format!("transfers to {eps:e}"),
    };
    let [by, about] = match args.method.shots {
        None => ["order", "; numbers are orders"],
        Some(_) if args.method.ambient => ["shots", "; with the ambient term"],
        Some(_) => ["shots", ""],
    };
    let caption = format!("L² difference from {against}; {accuracy}{about}");
    chart(format!("{title}: error by {by}"), caption, runs).drawing()
}

fn draw(drawing: &Drawing, kind: ChartFormat, output: &OutputFile) -> Result<(), CliError> {
    output.write(|writer| match kind {
        ChartFormat::Svg => writer.write_all(drawing.svg().as_bytes()),
        ChartFormat::Png => drawing.picture().write_png(writer),
    })
}

fn table(runs: &[ConvergenceRun]) -> Table<'_> {
    let are_shot = runs.iter().any(|run| run.shots.is_some());
    let counts = ["order", "layers", "elements", "unknowns"];
    let of_shots = ["shots", "columns"].into_iter().filter(|_| are_shot);
    let names = ["way"].into_iter().chain(counts).chain(of_shots).chain(["samples", "rays"]);
    let mut columns: Vec<Column> = names.map(Column::text).collect();
    columns.extend([
        Column::numbers("seconds", "").with(Digits::Decimals(4)),
        Column::numbers("error", "").with(Digits::Mantissa(3)),
        Column::numbers("rate", "").with(Digits::Decimals(2)),
        Column::numbers("energy", "").with(Digits::Mantissa(3)),
    ]);
    let row = |run: &ConvergenceRun| {
        let counts = [run.order, run.layers, run.elements, run.unknowns].map(Value::from);
        let shots = [run.shots, run.columns].into_iter().flatten().map(Value::from);
        let work = [run.samples, run.rays].map(Value::Count);
        let numbers = [run.seconds.into(), run.error.into(), run.rate.into(), run.energy.into()];
        [run.series.name().into()].into_iter().chain(counts).chain(shots).chain(work).chain(numbers)
    };
    Table::new(columns, runs.iter().map(row))
}
