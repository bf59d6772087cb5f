//! `radiosity heat`: temperatures and net flows of radiant heat.

mod picture;
mod setting;
mod sweep;

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Instant;

use clap::{Args, ValueEnum};
use radiosity_audit::{Checked, HeatFault};
use radiosity_heat::Heat;
use radiosity_heat::remarks::{
    adiabatic_backs, carried_by_rays, idle_order, light_without_heat, without_level,
};
use radiosity_heat::remarks::{corrected, heat_unchecked, heat_underestimated, no_error_of_cut};
use radiosity_kernel::WorstError;
use radiosity_output::documents::heat as output;
use radiosity_reading::accuracy_warning::missed;
use radiosity_request::{HeatRequest, HeatSweep, SceneRequest};
use radiosity_scene::{Fault, Scene, SceneError};
use radiosity_work::digits::significant;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Observer, Progress as Event, Stage, Work};

use crate::{
    destination::Destination,
    error::CliError,
    format,
    heat::picture::{HeatPicture, PictureArgs},
    heat::setting::Setting,
    options::SceneArg,
    output_file::OutputFile,
    progress::Progress,
    transfers::TransferArgs,
    typed_options::TypedOptions,
};

const NOTES: &str = "\
Examples:
  radiosity heat                              the built-in oven
  radiosity heat oven --set heater=1500       its panels at 1500 K
  radiosity heat oven --set brick.emissivity=0.5
  radiosity heat oven --sweep panel.emissivity=0.1..0.9/17 -o panel.csv
  radiosity heat satellite.toml -o nodes.csv --conductances C.csv
  radiosity heat oven --picture oven.png --isolines

Every surface, or its material, has one of temperature = … (K), heat_flux = … (W/m²) and adiabatic = true, and an
emissivity. Lengths are metres. The back of a surface of one side is adiabatic; back = \"front\" or back = … (K) say
otherwise. What leaves the scene goes to surroundings at 0 K. Conduction, convection and stored heat are left out; where
they are known, they are a heat_flux.

NAME.KEY of --set and --sweep is a quantity of a surface, of all whose names begin alike (\"wall-*\"), or of the surfaces of
a material; KEY is temperature, heat_flux or emissivity. The back of a surface of one side is set in the file alone. A
sweep finds the transfers once. Path tracing checks the balance of the largest flows, and errors of all others are as many
times larger.";

/// Temperatures, net fluxes and flows of radiant heat between grey surfaces
#[derive(Debug, Args)]
#[command(
    mut_arg("scene", |scene| scene.default_value("oven")),
    mut_arg("settings", |set| {
        set.value_name("NAME=VALUE|NAME.KEY=VALUE").help("Sets a parameter of a built-in scene (`radiosity scenes` lists them) or a variable of a scene file, or a quantity of heat of surfaces or of a material; as often as needed")
    }),
    mut_arg("eps", |eps| eps.help("Accuracy of the transfers between elements, between 0 and 1 [default: 1e-4]")),
    mut_arg("subdivide", |cuts| {
        cuts.help("Cuts each surface into K × K elements; auto looks at what the scene needs, and cuts faces along the outlines of others near by, and finer towards their sides [default: auto]")
    }),
    mut_arg("transport", |transport| transport.help("How the pairs of elements are carried [default: auto]")),
    mut_arg("rays", |rays| {
        rays.help("Rays of the sampled transport [default: by the number of surfaces and --shadow-eps]")
    }),
    mut_arg("memory", |memory| {
        memory.help("Most memory to use, such as 500M, 2G or 2GiB [default: 80 % of what is free]")
    }),
    mut_arg("strict", |strict| {
        strict.help("Ends with exit code 3 where path tracing finds more than the balance tells; refuses a scene of another program that needs repairs")
    }),
    after_help = NOTES
)]
pub(crate) struct HeatArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the figures, in the format of its ending: .csv or .json [default: a table on standard output]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Format of the figures
    #[arg(long, value_name = "FORMAT")]
    pub(crate) format: Option<Format>,

    /// File of the conductances C_ij (m²) between all surfaces for thermal networks, .csv, .json, .npy or
    /// .npz: from i to j flows C_ij σ (T_i⁴ − T_j⁴)
    #[arg(long, value_name = "FILE")]
    pub(crate) conductances: Option<PathBuf>,

    /// Balances for N values of a quantity from A to B, such as panel.emissivity=0.1..0.9/17, by transfers that are
    /// found once; the figures are then CSV or JSON
    #[arg(
        long,
        value_name = "NAME.KEY=A..B/N",
        value_parser = HeatSweep::from_str,
        conflicts_with_all = ["conductances", "picture"]
    )]
    sweep: Option<HeatSweep>,

    #[command(flatten)]
    request: HeatRequest,

    #[command(flatten)]
    transfers: TransferArgs,

    #[command(flatten)]
    picture: PictureArgs,
}

/// `--format` of the figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people
    Text,
    /// A row for each surface, numbers in full
    Csv,
    /// All rows with the balance
    Json,
}

/// Format of the conductances, by the ending of their file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MatrixFormat {
    Csv,
    Json,
    Npy,
    Npz,
}

/// Assumptions of a network of conductances.
const NETWORK: &str = "in a network of conductances each surface has one temperature; in the balance that of a surface \
                       of known flux varies over it, so that both differ there";

/// Part of ε A below which a negative conductance is rounding, and not told. Chosen.
const NO_CONDUCTANCE: f64 = 1e-12;

/// Digits of the table on standard output. Chosen.
const DIGITS: usize = 6;

/// Computes the balance of heat and writes it.
pub(crate) fn run(args: &HeatArgs, given: &TypedOptions, ranks: &Ranks) -> Result<(), CliError> {
    let start = Instant::now();
    let options = args.request.options(&args.transfers.request, args.conductances.is_some(), ranks)?;
    let settings = args.settings()?;
    let read = args.with_parameters(&settings, ranks)?;
    let scene = with_heat(&read, &settings)?;
    let ranks = &args.transfers.checkpoint.recording(given, &scene, &scene, &[], ranks)?;
    if let Some(sweep) = &args.sweep {
        return sweep::run(sweep, args, &options.options, start, &read, &scene, ranks);
    }
    let files = HeatFiles::reserve(args, &scene, ranks)?;
    let progress = Progress::new(args.transfers.quiet, options.options.threads, start, ranks);
    let show = |event| shown(event).into_iter().for_each(|event| progress.report(event));
    let work = Work::among(ranks).observed_by(&show);
    let mut heat = Heat::of(&scene, &options, &work)?;
    let checked = || args.transfers.check.check_heat(&mut heat, &scene, options.options.shadows, &work);
    let unchecked = options.options.in_threads(ranks, checked)?.err();
    progress.begin_output();
    files.write(&heat)?;
    let mut first = vec![];
    if let Some(picture) = files.picture {
        first.extend(picture.told.clone());
        let visibility = options.options.visibility(&scene);
        let take = || picture.take(&scene, &visibility, &heat, &work);
        let taken = options.options.in_threads(ranks, take)?;
        picture.file.write(|writer| taken.write_png(writer))?;
    }
    progress.clear();
    let elapsed = start.elapsed().as_secs_f64();
    first.insert(0, format!("{}: {} surfaces, {elapsed:.3} s", scene.name, heat.surfaces.len()));
    first.insert(1, progress.stages());
    let written = args.output.iter().chain(&args.conductances).chain(&args.picture.picture);
    let findings = findings(&scene, &heat, args.request.asked_order(), unchecked.as_ref());
    args.transfers.tell(first, &read, findings, written, ranks);
    judge(args, &heat)
}

/// Fails where a strict run finds more than the balance tells.
fn judge(args: &HeatArgs, heat: &Heat) -> Result<(), CliError> {
    match heat.checked.as_ref().filter(|checked| args.scene.strict && checked.finds_more()) {
        Some(checked) => Err(CliError::FoundMore { what: "the heat is", told: checked.own_error }),
        None => Ok(()),
    }
}

/// Progress of a balance that is shown: pairs and rays, and those of them that tell the error; the ledger hears of all
/// stages.
fn shown(event: Event) -> Option<Event> {
    let is_shown = match event {
        Event::Done { stage, .. } => matches!(stage, Stage::Blocks | Stage::Comparison | Stage::Runs),
        Event::Expected { .. } | Event::Rays { .. } | Event::Began { .. } | Event::Ended { .. } => true,
        Event::Iteration { .. } => false,
    };
    is_shown.then_some(event)
}

impl HeatArgs {
    /// The settings in the order in which they were typed.
    fn settings(&self) -> Result<Vec<Setting>, Fault> {
        self.scene.settings.iter().map(|(name, value)| Setting::of(name, *value)).collect()
    }

    /// The scene with its parameters, variables and light groups as they were set.
    fn with_parameters(&self, settings: &[Setting], ranks: &Ranks) -> Result<Scene, CliError> {
        let settings = settings.iter().filter_map(Setting::parameter).collect();
        Ok(SceneRequest { settings, ..self.scene.request() }.load_lit(ranks)?)
    }
}

/// The scene with the heat of its surfaces as it was set.
fn with_heat(read: &Scene, settings: &[Setting]) -> Result<Scene, SceneError> {
    settings.iter().try_fold(read.clone(), |scene, setting| match setting {
        Setting::Heat { quantity, value } => scene.with_heat(quantity, *value),
        Setting::Parameter { .. } => Ok(scene),
    })
}

/// The files of a balance, reserved before the work.
struct HeatFiles<'a> {
    format: Format,
    figures: Destination,
    matrix: Option<(MatrixFormat, OutputFile)>,
    picture: Option<HeatPicture<'a>>,
}

impl<'a> HeatFiles<'a> {
    /// The files that were asked for, if they can be written and are apart from each other.
    fn reserve(args: &'a HeatArgs, scene: &Scene, ranks: &Ranks) -> Result<Self, CliError> {
        let [output, conductances] = [&args.output, &args.conductances].map(Option::as_deref);
        let format = format::chosen(args.format, output, Format::Text)?;
        let matrix_format = conductances.map(format::of_file::<MatrixFormat>).transpose()?;
        let reserve = |path: &Path| args.scene.reserve(path, ranks);
        let figures = Destination::of(output.map(reserve).transpose()?, ranks);
        let apart = |path: &Path| reserve(path)?.apart_from(output, "the figures");
        let matrix = conductances.map(apart).transpose()?;
        let picture = |path: &Path| apart(path)?.apart_from(conductances, "the conductances");
        let picture = args.picture.wanted(scene, picture)?;
        Ok(Self { format, figures, matrix: matrix_format.zip(matrix), picture })
    }

    /// Writes the figures and the conductances.
    fn write(&self, heat: &Heat) -> Result<(), CliError> {
        self.figures.write(|writer| match self.format {
            Format::Text => write!(writer, "{}", output::table(&heat.surfaces, DIGITS)),
            Format::Csv => output::csv(&heat.surfaces, writer),
            Format::Json => output::json(heat, writer),
        })?;
        let (Some((format, file)), Some(conductances)) = (&self.matrix, &heat.conductances) else {
            return Ok(());
        };
        let names: Vec<&str> = heat.surfaces.iter().map(|surface| surface.name.as_str()).collect();
        file.write(|writer| match format {
            MatrixFormat::Csv => output::conductances_csv(&names, conductances, writer),
            MatrixFormat::Json => output::conductances_json(&names, conductances, writer),
            MatrixFormat::Npy => output::conductances_npy(conductances, writer),
            MatrixFormat::Npz => output::conductances_npz(&heat.surfaces, conductances, writer),
        })
    }
}

/// The lines of the summary on the balance, which no referee may have been able to read, and of which an order may have
/// been asked for.
fn findings(
    scene: &Scene,
    heat: &Heat,
    asked_order: Option<usize>,
    unchecked: Option<&HeatFault>,
) -> Vec<String> {
    let sum = |sign: f64| -> f64 { heat.surfaces.iter().map(|own| (sign * own.flow).max(0.0)).sum() };
    let (given, taken) = (sum(1.0), sum(-1.0));
    let whole = if !heat.is_closed() {
        format!("{} W leave the scene, to surroundings at 0 K", significant(heat.lost, 6))
    } else {
        format!("the scene is closed: the flows sum to {:.1e} W", heat.lost)
    };
    let mut lines: Vec<String> = heat.moved.map(corrected).into_iter().collect();
    lines.extend(carried_by_rays(&heat.outcome));
    lines.extend(light_without_heat(scene));
    lines.extend(adiabatic_backs(&heat.usual_backs(scene)));
    lines.extend(without_level(&heat.without_level));
    lines.push(format!(
        "surfaces send out {} W and take up {} W; {whole}",
        significant(given, 6),
        significant(taken, 6)
    ));
    if let Some(conductances) = &heat.conductances {
        lines.push(format!(
            "conductances: C_ij and C_ji differ by {:.1e} of ε A at the most; their means are written",
            conductances.asymmetry
        ));
        if conductances.negative > NO_CONDUCTANCE {
            lines.push(format!(
                "conductances: negative ones, {:.1e} of ε A at the most, were made 0; the sums of rows were kept",
                conductances.negative
            ));
        }
        if heat.surfaces.iter().any(|own| own.is_flow_known && own.has_level()) {
            lines.push(NETWORK.to_owned());
        }
    }
    if let Some(worst) = heat.outcome.worst_error.filter(WorstError::is_real) {
        let surface = |element: usize| heat.outcome.solution.elements().list()[element].surface;
        let names = worst.pair.map(|element| heat.surfaces[surface(element)].name.as_str());
        lines.push(format!("warning: {}", missed(&worst, names)));
    }
    lines.extend(heat.checked.as_ref().map(Checked::to_string));
    lines.extend(unchecked.map(heat_unchecked));
    let underestimated = heat.checked.as_ref().and_then(|own| heat_underestimated(own, &heat.outcome));
    let no_error = (!heat.is_cut).then(|| no_error_of_cut(&heat.outcome));
    let warnings = [idle_order(&heat.outcome, asked_order), underestimated, no_error];
    lines.extend(warnings.into_iter().flatten().map(|warning| format!("warning: {warning}")));
    lines
}
