//! `radiosity audit`: light that is printed, judged by a referee.

mod picture;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use radiosity_audit::Referee;
use radiosity_output::documents::audit as output;
use radiosity_reading::judging::{JudgedRun, Judging};
use radiosity_request::{AuditRequest, ReadRequest, require_all_light};
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, words};

use crate::{
    aim::wanted,
    console,
    destination::Destination,
    error::CliError,
    format,
    loaded::Loaded,
    options::{PARAMETER_OR_GROUP, SCENE_OR_SOLUTION, SceneArg},
    run::{Run, RunArgs},
};
use picture::MarkArgs;

const NOTES: &str = "\
Readings are points even over the fronts of all surfaces and, where the scene has planes, a third of them sensors. Each is \
read as `probe` reads it and estimated by walks of light that know the scene alone: what a ray meets, what surfaces send and \
reflect, points on lamps. Both share the scene: its import, the fitting of its shapes, the models of luminaires, skies and \
glass; these are not judged. What differs by more than chance and by more than the run tells is named, and looked at a \
second time with other rays.

Examples:
  radiosity audit cornell-box
  radiosity audit room.toml --seconds 20 --picture where.png
  radiosity solve room.toml -o room.solution.json && radiosity audit room.solution.json --strict
  radiosity audit room.toml --readings 256 --format json -o audit.json";

/// Solves a scene and judges its light by path tracing, with the readings that differ most
#[derive(Debug, Args)]
#[command(
    mut_arg("scene", |scene| scene.help(SCENE_OR_SOLUTION)),
    mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)),
    mut_arg("strict", |strict| {
        strict.help("Ends with exit code 3 where more is found than the run tells; refuses a scene of another program that needs repairs")
    }),
    after_help = NOTES
)]
pub(crate) struct AuditArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

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

/// Solves the scene, judges its light and prints the verdict.
pub(crate) fn run(args: &AuditArgs, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
    let RunArgs { method, report, .. } = &args.run;
    require_all_light(method, "the referee judges all light", |name| words("leave out ") + option(name))?;
    args.read.check(&loaded.options(method, ranks), method)?;
    let reserve = |path: &PathBuf| loaded.reserve(path, report, ranks);
    let destination = Destination::of(args.output.as_ref().map(reserve).transpose()?, ranks);
    let format = format::chosen(args.format, args.output.as_deref(), Format::Text)?;
    let picture = args.marks.wanted(&loaded, report, args.output.as_deref(), ranks)?;
    let goal = wanted(method, loaded.scene(), ranks)?;
    let goal = goal.map(|goal| goal.read_by(args.read.read_by.unwrap_or_default()));
    let run = Run::to(goal, loaded, &args.run, ranks)?;
    let reading = args.read.reading(method, &run.solved, run.is_saved());
    let judging = args.audit.judging(&run.solved, &reading);
    let referee = Referee::of_light(&run.solved.scene);
    let judge = || JudgedRun::of(&run.solved, &reading, &referee, &judging, &run.work());
    let judged = run.in_threads(judge)?;
    require_readings(&judged)?;
    let scene = &run.solved.scene;
    destination.write(|writer| match format {
        Format::Text => write!(writer, "{}", output::text(scene, &judging, &judged)),
        Format::Csv => output::csv(scene, &judged, writer),
        Format::Json => output::json(scene, &judging, &judged, writer),
    })?;
    if let Some(picture) = &picture {
        let taken = run.in_threads(|| picture.take(&run.solved, &judged, ranks))?;
        picture.file.write(|writer| taken.write_png(writer))?;
    }
    if !report.quiet && (format != Format::Text || args.output.is_some()) {
        let lines = [Some(judged.to_string()), output::finding(&judging, &judged)];
        console::tell(&lines.into_iter().flatten().collect::<Vec<_>>(), ranks);
    }
    let files = args.output.iter().chain(&args.marks.picture).map(|path| path.display().to_string());
    let written = files.collect::<Vec<_>>().join(" and ");
    run.finish((!written.is_empty()).then_some(written.as_str()))?;
    args.judge(&judging, &judged)
}

/// Refuses a verdict on too few readings.
fn require_readings(judged: &JudgedRun) -> Result<(), CliError> {
    match judged.readings.len() {
        0 | 1 => Err(CliError::refused(
            format!("{} places can be read, too few to be judged", judged.readings.len()),
            "ask for more --readings, or take --read gather",
        )),
        _ => Ok(()),
    }
}

impl AuditArgs {
    /// Fails where a strict run finds more than is told.
    fn judge(&self, judging: &Judging, judged: &JudgedRun) -> Result<(), CliError> {
        match self.scene.strict && judged.verdict.finds(judging.told) {
            true => Err(CliError::FoundMore { told: judging.told }),
            false => Ok(()),
        }
    }
}
