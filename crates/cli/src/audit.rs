//! `radiosity audit`: light, heat or view factors that are printed, judged by a referee.

mod picture;

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::{Args, Command, ValueEnum};
use radiosity_audit::{Checked, Referee, WalkCost};
use radiosity_heat::Heat;
use radiosity_heat::judging::JudgedHeat;
use radiosity_output::documents::audit as output;
use radiosity_output::documents::audit::Judgement;
use radiosity_reading::judged_factors::JudgedFactors;
use radiosity_reading::judging::JudgedRun;
use radiosity_request::{
    AuditRequest, HeatRequest, MethodRequest, ReadRequest, TransferRequest, require_all_light,
};
use radiosity_scene::Scene;
use radiosity_solve::in_threads;
use radiosity_solve::view_factors::ViewFactors;
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, words};
use radiosity_work::{Stage, Work};

use crate::{
    aim::wanted,
    console,
    destination::Destination,
    error::CliError,
    format,
    loaded::{Loaded, outside},
    options::{PARAMETER_OR_GROUP, SCENE_OR_SOLUTION, SceneArg},
    output_file::OutputFile,
    progress::Progress,
    run::{Run, RunArgs},
    typed_options::TypedOptions,
};
use picture::MarkArgs;

const NOTES: &str = "\
Readings are points even over the fronts of all surfaces and, where the scene has planes, a third of them sensors. Each is \
read as `probe` reads it and estimated by walks of light that know the scene alone: what a ray meets, what surfaces send and \
reflect, points on lamps. Both share the scene: its import, the fitting of its shapes, the models of luminaires, skies and \
glass; these are not judged. What differs by more than chance and by more than the run tells is named, and looked at a \
second time with other rays.

Of heat, the flow of each surface of known temperature is judged, and the temperature of each other one; of view factors,
those from 1e-3 on of --readings surfaces. Both take the defaults of the verbs `heat` and `view-factors`, and those options of
the method that these have, such as --eps and --shadows.

Examples:
  radiosity audit cornell-box
  radiosity audit room.toml --seconds 20 --picture where.png
  radiosity solve room.toml -o room.solution.json && radiosity audit room.solution.json --strict
  radiosity audit room.toml --readings 256 --format json -o audit.json
  radiosity audit oven --of heat --strict
  radiosity audit faces.csv --of view-factors";

/// Solves a scene and judges its light, heat or view factors by path tracing, with what differs most
#[derive(Debug, Args)]
#[command(
    mut_arg("scene", |scene| scene.help(SCENE_OR_SOLUTION)),
    mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)),
    mut_arg("audit", |audit| audit.hide(true)),
    mut_arg("strict", |strict| {
        strict.help("Ends with exit code 3 where more is found than the run tells; refuses a scene of another program that needs repairs")
    }),
    after_help = NOTES
)]
pub(crate) struct AuditArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// Numbers that are judged, those of `probe`, `heat` or `view-factors`
    #[arg(long, value_name = "WHAT", default_value = "light")]
    of: Subject,

    #[command(flatten)]
    pub(crate) audit: AuditRequest,

    #[command(flatten)]
    pub(crate) read: ReadRequest,

    /// Format of the figures [default: that of the file's ending, or text]
    #[arg(long, value_name = "FORMAT")]
    format: Option<Format>,

    /// File of the figures, .csv or .json [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    #[command(flatten)]
    marks: MarkArgs,

    #[command(flatten)]
    pub(crate) run: RunArgs,
}

/// `--format` of the figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people: the verdict, the worst readings, signed means
    Text,
    /// A row for each reading, numbers in full
    Csv,
    /// The verdict and all readings
    Json,
}

/// `--of` of the numbers that are judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Subject {
    /// Light, as `probe` reads it
    Light,
    /// Flows and temperatures, as `heat` prints them
    Heat,
    /// Parts of what leaves surfaces that reach others, as `view-factors` prints them
    ViewFactors,
}

impl Subject {
    fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Heat => "heat",
            Self::ViewFactors => "view-factors",
        }
    }
}

/// Judges what was asked for and prints the verdict.
pub(crate) fn run(
    args: &AuditArgs,
    fixing: &[String],
    given: &TypedOptions,
    ranks: &Ranks,
) -> Result<(), CliError> {
    if args.run.check.audit.is_some() {
        return Err(CliError::refused(
            "--audit says how long another verb is checked, and this one does nothing else",
            "take --seconds instead",
        ));
    }
    match args.of {
        Subject::Light => args.light(fixing, given, ranks),
        Subject::Heat => {
            args.require_known(given, HeatRequest::augment_args(transfers()))?;
            args.heat(given, ranks)
        }
        Subject::ViewFactors => {
            args.require_known(given, transfers())?;
            args.view_factors(given, ranks)
        }
    }
}

/// The options of transfers.
fn transfers() -> Command {
    TransferRequest::augment_args(Command::new("transfers"))
}

/// Where a verdict goes, and in which format.
struct Outlet {
    destination: Destination,
    format: Format,
}

impl Outlet {
    /// Writes the verdict in full; what of it is to be told besides, unless that is not wanted.
    fn write(&self, judgement: &Judgement<'_>, args: &AuditArgs, ranks: &Ranks) -> Result<(), CliError> {
        self.destination.write(|writer| match self.format {
            Format::Text => write!(writer, "{}", judgement.text()),
            Format::Csv => judgement.csv(writer),
            Format::Json => judgement.json(writer),
        })?;
        if !args.run.report.quiet && (self.format != Format::Text || args.output.is_some()) {
            console::tell(&judgement.summary(), ranks);
        }
        Ok(())
    }
}

impl AuditArgs {
    /// Solves the scene and judges its light.
    fn light(&self, fixing: &[String], given: &TypedOptions, ranks: &Ranks) -> Result<(), CliError> {
        let loaded = Loaded::dark_or_lit(&self.scene, fixing, ranks)?;
        if loaded.scene().require_light().is_err() && Heat::is_known(loaded.scene()) {
            return Err(CliError::refused(
                format!("{}: nothing emits light, but temperatures or fluxes are given", self.scene.scene),
                "add --of heat, which judges what `radiosity heat` prints",
            ));
        }
        let loaded = loaded.required()?;
        if !WalkCost::of_light(loaded.scene()).ends() {
            return Err(too_few(0));
        }
        let RunArgs { method, report, .. } = &self.run;
        let ranks = &self.run.recording(given, &loaded.inputs(), loaded.scene(), None, ranks)?;
        require_all_light(method, "the referee judges all light", |name| words("leave out ") + option(name))?;
        self.read.check(&loaded.options(method, ranks), method)?;
        let outlet = self.outlet(|path| loaded.reserve(path, report, ranks), ranks)?;
        let picture = self.marks.wanted(&loaded, report, self.output.as_deref(), ranks)?;
        let goal = wanted(method, loaded.scene(), ranks)?;
        let goal = goal.map(|goal| goal.read_by(self.read.read_by.unwrap_or_default()));
        let run = Run::to(goal, loaded, &self.run, ranks)?;
        let reading = self.read.reading(method, &run.solved, run.is_saved());
        let judging = self.audit.judging(&run.solved.scene);
        let referee = Referee::of_light(&run.solved.scene);
        let judge = || JudgedRun::of(&run.solved, &reading, &referee, &judging, &run.work());
        let judged = run.in_threads(|| run.work().during(Stage::Referee, judge))?;
        if judged.readings.len() < FEWEST {
            return Err(too_few(judged.readings.len()));
        }
        outlet.write(&output::light::judgement(&run.solved.scene, &judging, &judged), self, ranks)?;
        if let Some(picture) = &picture {
            let taken = run.in_threads(|| picture.take(&run.solved, &judged, ranks))?;
            picture.file.write(|writer| taken.write_png(writer))?;
        }
        let files = self.output.iter().chain(&self.marks.picture).map(|path| path.display().to_string());
        let mut written = files.collect::<Vec<_>>().join(" and ");
        let view = picture.as_ref().and_then(|picture| picture.told.as_ref());
        view.into_iter().for_each(|view| written += &format!("; {view}"));
        run.finish((!written.is_empty()).then_some(written.as_str()))?;
        self.judge("the light is", &judged.checked)
    }

    /// Computes the balance of heat and judges it.
    fn heat(&self, given: &TypedOptions, ranks: &Ranks) -> Result<(), CliError> {
        let started = Instant::now();
        let scene = self.scene.request().load_lit(ranks)?;
        let ranks = &self.run.checkpoint.recording(given, &scene, &scene, &[], ranks)?;
        let outlet = self.outlet(|path| self.scene.reserve(path, ranks), ranks)?;
        let method = &self.run.method;
        let options = HeatRequest::of(method)?.options(&TransferRequest::of(method)?, false, ranks)?;
        let progress = Progress::of(&self.run.report, options.options.threads, started, ranks);
        let work = Work::among(ranks).observed_by(&progress);
        let heat = Heat::of(&scene, &options, &work)?;
        let surfaces = self.audit.chosen(&heat.judgeable(&scene));
        let effort = self.audit.effort(surfaces.len(), &WalkCost::of_heat(&scene));
        let judge = || JudgedHeat::of(&scene, &heat, &surfaces, &effort, &work);
        let judged = options.options.in_threads(ranks, || work.during(Stage::Referee, judge))??;
        progress.clear();
        progress.begin_output();
        outlet.write(&output::heat::judgement(&judged), self, ranks)?;
        self.tell_files(&scene, ranks);
        self.judge("the heat is", &judged.checked)
    }

    /// Computes view factors and judges them.
    fn view_factors(&self, given: &TypedOptions, ranks: &Ranks) -> Result<(), CliError> {
        let started = Instant::now();
        let scene = self.scene.request().load(ranks)?;
        let ranks = &self.run.checkpoint.recording(given, &scene, &scene, &[], ranks)?;
        let outlet = self.outlet(|path| self.scene.reserve(path, ranks), ranks)?;
        let options = TransferRequest::of(&self.run.method)?.factors()?;
        let progress = Progress::of(&self.run.report, options.threads, started, ranks);
        let work = Work::among(ranks).observed_by(&progress);
        let factors = ViewFactors::new(&scene, &options, &work)?;
        let rows = self.audit.chosen(&(0..scene.surfaces.len()).collect::<Vec<_>>());
        let effort = self.audit.effort(rows.len(), &WalkCost::of_view_factors(&scene));
        let judge = || JudgedFactors::of(&scene, &factors, &rows, &|_, _| true, &effort, &work);
        let judge = || work.during(Stage::Referee, judge);
        let judged = in_threads(ranks.threads(options.threads), judge)?;
        progress.clear();
        progress.begin_output();
        if judged.factors.is_empty() {
            return Err(CliError::refused(
                "no view factor is large enough to be judged",
                "ask for more --readings: surfaces that see no other have no factors",
            ));
        }
        outlet.write(&output::view_factors::judgement(&judged), self, ranks)?;
        self.tell_files(&scene, ranks);
        self.judge("the view factors are", &judged.checked)
    }

    /// Tells which files were read outside the folder of the scene, and which was written, where one was.
    fn tell_files(&self, scene: &Scene, ranks: &Ranks) {
        let written = self.output.as_ref().map(|path| format!("wrote {}", path.display()));
        let lines: Vec<String> = outside(scene).into_iter().chain(written).collect();
        if !lines.is_empty() && !self.run.report.quiet {
            console::tell(&lines, ranks);
        }
    }

    /// Where the verdict goes; `reserve` finds out whether a file can be written.
    fn outlet(
        &self,
        reserve: impl FnOnce(&Path) -> Result<OutputFile, CliError>,
        ranks: &Ranks,
    ) -> Result<Outlet, CliError> {
        let output = self.output.as_deref();
        let destination = Destination::of(output.map(reserve).transpose()?, ranks);
        Ok(Outlet { destination, format: format::chosen(self.format, output, Format::Text)? })
    }

    /// Refuses options of light that what is judged does not have; `own` has those that it has.
    fn require_known(&self, given: &TypedOptions, own: Command) -> Result<(), CliError> {
        let light = MarkArgs::augment_args(ReadRequest::augment_args(MethodRequest::augment_args(
            Command::new("light"),
        )));
        let typed = given.first_beside(&light, &own);
        let report = self.run.report.report.as_ref().map(|_| "report");
        let limit = self.run.method.time_limit.map(|_| "time_limit");
        let Some(id) = typed.or(report).or(limit) else { return Ok(()) };
        Err(CliError::refused(
            format!("--{} does nothing with --of {}", id.replace('_', "-"), self.of.name()),
            "leave it out, or judge light with --of light",
        ))
    }

    /// Fails where a strict run finds more than is told.
    fn judge(&self, what: &'static str, checked: &Checked) -> Result<(), CliError> {
        match self.scene.strict && checked.finds_more() {
            true => Err(CliError::FoundMore { what, told: checked.own_error }),
            false => Ok(()),
        }
    }
}

/// Fewest readings that make a verdict.
const FEWEST: usize = 2;

/// Refuses a verdict on so few readings.
fn too_few(readings: usize) -> CliError {
    CliError::refused(
        format!(
            "walks of path tracing end at {readings} places, too few for a verdict: light goes on where surfaces \
             reflect nearly all of it"
        ),
        "give the materials there a lower reflectance",
    )
}
