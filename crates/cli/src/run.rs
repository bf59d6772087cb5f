//! The run of every verb that needs light: it solves first, with progress and a report.

mod check;
mod summary;

use std::fmt::Debug;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use clap::Args;
use radiosity_reading::checkpoint::Checkpoint;
use radiosity_reading::exposure::Exposure;
use radiosity_reading::plane_figures::PlaneFigures;
use radiosity_reading::probe::ProbeReading;
use radiosity_reading::quality::ReadSettings;
use radiosity_reading::rank_work::RanksWork;
use radiosity_reading::read_error::ReadError;
use radiosity_reading::reader::Reader;
use radiosity_reading::report::Report;
use radiosity_request::{CheckRequest, MethodRequest};
use radiosity_scene::Scene;
use radiosity_solve::gather::gather_method::GatherMethod;
use radiosity_solve::gather::read_irradiance::Deviation;
use radiosity_solve::solved::Solved;
use radiosity_solve::studies::adaptation::Goal;
use radiosity_solve::{Options, in_threads};
use radiosity_work::ranks::Ranks;
use radiosity_work::{Allowance, Deadline, Pace, Stage, Work};

use crate::aim::{points_file, wanted};
use crate::checkpoint::CheckpointArgs;
use crate::console;
use crate::error::CliError;
use crate::interrupt;
use crate::loaded::{Content, Loaded};
use crate::options::ReportArgs;
use crate::output_file::OutputFile;
use crate::progress::Progress;
use crate::typed_options::TypedOptions;

/// Parts of a limited time after which light is solved, and read; the check has the rest. Chosen.
const SOLVED: f64 = 0.5;
const DONE: f64 = 0.9;

/// Part of the time left that reading by cells may take by its forecast. Chosen.
const SOON: f64 = 0.4;

/// How a scene is solved, where that is recorded, and what is told of it.
#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    #[command(flatten)]
    pub(crate) method: MethodRequest,

    #[command(flatten)]
    pub(crate) checkpoint: CheckpointArgs,

    #[command(flatten)]
    pub(crate) check: CheckRequest,

    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

impl RunArgs {
    /// The ranks, which record their work, or keep the transfers of `scene`, if that was asked for. Results depend on
    /// the options `given`, on `inputs`, on the points of the method, and on an `other` file.
    pub(crate) fn recording(
        &self,
        given: &TypedOptions,
        inputs: &dyn Debug,
        scene: &Scene,
        other: Option<&Path>,
        ranks: &Ranks,
    ) -> Result<Ranks, CliError> {
        self.checkpoint.recording(given, inputs, scene, &[points_file(&self.method), other], ranks)
    }
}

/// A solved scene with its report in progress.
///
/// A verb reads [`Run::solved`], within [`Run::in_threads`] where that is long, and ends with
/// [`Run::finish`].
#[derive(Debug)]
pub(crate) struct Run {
    /// The scene, its solution and its figures.
    pub(crate) solved: Solved,
    /// Threads to work with.
    pub(crate) threads: usize,
    report: Report,
    check: CheckRequest,
    /// Whether the check was left out because time was up.
    is_unchecked: AtomicBool,
    start: Start,
}

/// A run before its scene is solved.
#[derive(Debug)]
struct Start {
    ranks: Ranks,
    progress: Progress,
    deadline: Option<Arc<Deadline>>,
    /// End of what is read, of a run whose time is limited.
    read_until: Option<Instant>,
    /// End of all of it.
    limit: Option<Deadline>,
    report_file: Option<OutputFile>,
    /// Whether the solution was read from a file.
    is_saved: bool,
    /// Whether the run fails where a check finds more than the method tells.
    is_strict: bool,
    started: Instant,
}

impl Start {
    /// The start of a run of so many threads (0: all) on a loaded scene; finds out whether the report can be written.
    fn of(
        loaded: &Loaded,
        report: &ReportArgs,
        threads: usize,
        deadline: Option<Arc<Deadline>>,
        ranks: &Ranks,
    ) -> Result<Self, CliError> {
        Ok(Self {
            ranks: ranks.clone(),
            progress: Progress::of(report, threads, loaded.started, ranks),
            deadline,
            read_until: None,
            limit: None,
            report_file: report.reserve(ranks)?.map(|file| loaded.apart(file)).transpose()?,
            is_saved: matches!(loaded.content, Content::Solved(_)),
            is_strict: loaded.is_strict,
            started: loaded.started,
        })
    }

    fn work(&self) -> Work<'_> {
        Work { ranks: &self.ranks, observer: &self.progress, deadline: self.deadline.as_deref() }
    }
}

/// The deadline at this part of a limited time; None without a limit.
fn deadline(args: &RunArgs, loaded: &Loaded, part: f64) -> Option<Arc<Deadline>> {
    args.method.part_ends(loaded.started, part).map(|ends| Arc::new(Deadline::at(Some(ends))))
}

impl Run {
    /// Solves the scene, unless its solution was read.
    pub(crate) fn solve(loaded: Loaded, args: &RunArgs, ranks: &Ranks) -> Result<Self, CliError> {
        let goal = wanted(&args.method, loaded.scene(), ranks)?;
        Self::to(goal, loaded, args, ranks)
    }

    /// Solves until the goal is reached, if there is one.
    pub(crate) fn to(
        goal: Option<Goal>,
        loaded: Loaded,
        args: &RunArgs,
        ranks: &Ranks,
    ) -> Result<Self, CliError> {
        let deadline = deadline(args, &loaded, SOLVED);
        Self::with_options(args.method.options(ranks), goal, loaded, args, deadline, ranks)
    }

    /// Solves as [`Run::solve`], of which nothing is read but by the check.
    pub(crate) fn alone(loaded: Loaded, args: &RunArgs, ranks: &Ranks) -> Result<Self, CliError> {
        let goal = wanted(&args.method, loaded.scene(), ranks)?;
        let deadline = deadline(args, &loaded, DONE);
        Self::with_options(args.method.options(ranks), goal, loaded, args, deadline, ranks)
    }

    /// Solves as [`Run::alone`], and keeps what there is where the solver does not converge, or where Ctrl-C
    /// ends the rays.
    pub(crate) fn keeping_parts(loaded: Loaded, args: &RunArgs, ranks: &Ranks) -> Result<Self, CliError> {
        let goal = wanted(&args.method, loaded.scene(), ranks)?;
        let deadline = Some(interrupt::soften(args.method.part_ends(loaded.started, DONE)));
        let options = Options { keep_partial: true, ..args.method.options(ranks) };
        Self::with_options(options, goal, loaded, args, deadline, ranks)
    }

    fn with_options(
        options: Options,
        goal: Option<Goal>,
        loaded: Loaded,
        args: &RunArgs,
        deadline: Option<Arc<Deadline>>,
        ranks: &Ranks,
    ) -> Result<Self, CliError> {
        args.method.check()?;
        args.check.check(&loaded.options(&args.method, ranks))?;
        let read_until = args.method.part_ends(loaded.started, DONE);
        let limit = args.method.part_ends(loaded.started, 1.0).map(|ends| Deadline::at(Some(ends)));
        let start = Start {
            read_until,
            limit,
            ..Start::of(&loaded, &args.report, options.threads, deadline, ranks)?
        };
        let solved = match (loaded.content, goal) {
            (Content::Solved(solved), _) => *solved,
            (Content::Scene(scene), Some(goal)) => {
                Solved::to_accuracy(*scene, &options, &goal, &start.work())?
            }
            (Content::Scene(scene), None) => Solved::new(*scene, options, &start.work())?,
        };
        Ok(Self::new(solved, start, args.check, options.threads))
    }

    /// Takes a solution file as it was read.
    pub(crate) fn read(
        loaded: Loaded,
        check: CheckRequest,
        report: &ReportArgs,
        ranks: &Ranks,
    ) -> Result<Self, CliError> {
        let start = Start::of(&loaded, report, 0, None, ranks)?;
        match loaded.content {
            Content::Solved(solved) => {
                check.check(&solved.options)?;
                Ok(Self::new(*solved, start, check, 0))
            }
            Content::Scene(_) => unreachable!("a solution file was read"),
        }
    }

    fn new(solved: Solved, start: Start, check: CheckRequest, threads: usize) -> Self {
        let threads = start.ranks.threads(threads);
        start.progress.begin_output();
        let report = Report::new(&solved, threads);
        Self { solved, threads, report, check, is_unchecked: false.into(), start }
    }

    /// Whether the solution was read from a file.
    pub(crate) fn is_saved(&self) -> bool {
        self.start.is_saved
    }

    /// Work on the solution: by the ranks of the run, with its progress and deadline.
    pub(crate) fn work(&self) -> Work<'_> {
        self.start.work()
    }

    /// The instant until which light is read, where time is limited; None among several ranks, whose clocks differ, and
    /// where pieces are recorded, which a later run takes for done.
    fn read_until(&self) -> Option<Instant> {
        self.start.read_until.filter(|_| self.start.ranks.are_alone() && !self.start.ranks.record_all())
    }

    /// As [`Run::time_left`], beside forecasts of what is read.
    pub(crate) fn allowance(&self) -> Option<Allowance> {
        Some(Allowance::until(self.read_until()?, self.threads))
    }

    /// The time left to read light, where it is limited.
    pub(crate) fn time_left(&self) -> Option<Duration> {
        Some(self.read_until()?.saturating_duration_since(Instant::now()))
    }

    /// The pace at which so many points or cells are read, where time is limited.
    pub(crate) fn pace(&self, readings: usize) -> Option<Pace> {
        self.read_until().map(|ends| Pace::of(readings, self.threads, ends))
    }

    /// The reader of the solution with these settings, at this pace: then by rays, which may end at any time, unless
    /// cells are asked for or are soon done.
    pub(crate) fn reader<'a>(&'a self, settings: &ReadSettings, pace: Option<&'a Pace>) -> Reader<'a> {
        let reader = |settings: &ReadSettings| {
            let make = || settings.reader(&self.solved.outcome.solution, self.solved.visibility());
            self.work().during(Stage::Tables, make)
        };
        match pace {
            Some(pace) => reader(&self.paced(settings, pace)).paced(pace),
            None => reader(settings),
        }
    }

    /// The settings of what is read at this pace: by rays, unless cells are asked for or are soon done.
    fn paced(&self, settings: &ReadSettings, pace: &Pace) -> ReadSettings {
        let are_soon_done =
            self.seconds_to_read(settings, pace.left()) < SOON * pace.time_left().as_secs_f64();
        let by = match settings.by {
            GatherMethod::Auto if !are_soon_done => GatherMethod::Rays,
            by => by,
        };
        ReadSettings { by, ..*settings }
    }

    /// The progress that is shown.
    pub(crate) fn progress(&self) -> &Progress {
        &self.start.progress
    }

    /// Runs long work with as many threads as were asked for.
    pub(crate) fn in_threads<T: Send>(&self, work: impl FnOnce() -> T + Send) -> Result<T, CliError> {
        Ok(in_threads(self.threads, work)?)
    }

    /// The report so far.
    pub(crate) fn report(&self) -> &Report {
        &self.report
    }

    /// Adds the exposure of the picture to the report.
    pub(crate) fn add_exposure(&mut self, exposure: Exposure) {
        self.report.exposure = Some(exposure);
    }

    /// Adds the figures of planes to the summary and to the report.
    pub(crate) fn add_planes(&mut self, planes: Vec<PlaneFigures>) {
        self.report.add_planes(planes);
    }

    /// Warns of points outside of the room.
    pub(crate) fn add_points(&mut self, readings: &[ProbeReading]) {
        self.report.add_points(readings);
    }

    /// Takes the error of readings by walks, if light had to be read so: their deviations, of which each reading has
    /// its light, one number a band, over that light in the L2 mean.
    pub(crate) fn take_error_of_walks<'a>(
        &mut self,
        readings: impl Iterator<Item = (&'a [f64], Option<Deviation>)>,
    ) {
        if !self.is_by_walks() {
            return;
        }
        let (mut missed, mut size) = (0.0, 0.0);
        for (light, deviation) in readings {
            let square: f64 = light.iter().map(|value| value * value).sum();
            missed += light.len() as f64 * deviation.map_or(0.0, |deviation| deviation.absolute.powi(2));
            size += square;
        }
        let error = if size > 0.0 { (missed / size).sqrt() } else { 0.0 };
        self.solved.achieved = self.solved.achieved.map(|achieved| achieved.read(error));
        self.report.take_achieved(&self.solved);
    }

    /// Whether light has to be read by walks to have the accuracy that was wanted.
    fn is_by_walks(&self) -> bool {
        self.solved.achieved.is_some_and(|achieved| achieved.by == GatherMethod::Walks)
    }

    /// Adds the errors of readings by rays that were to err by `asked`, read at this pace.
    pub(crate) fn add_read_error(&mut self, error: Option<ReadError>, asked: f64, pace: Option<&Pace>) {
        // Walks are asked for an error relative to the mean, and what is dark errs by more of itself.
        let asked = if self.is_by_walks() { f64::INFINITY } else { asked };
        let was_cut_short = pace.is_some_and(Pace::has_cut_short);
        self.report.add_read_error(error, asked, was_cut_short);
    }

    /// Ends the run: times the output, writes the summary to stderr, writes the report; fails where a wanted
    /// accuracy was not reached, and a strict run where more is found than the method tells.
    pub(crate) fn finish(mut self, written: Option<&str>) -> Result<(), CliError> {
        let Start { ranks, progress, report_file, is_saved, is_strict, .. } = &self.start;
        if report_file.is_some() || progress.verbose {
            self.report.compare_joints(&self.solved);
        }
        self.report.seconds = progress.ledger().report();
        self.report.ranks = RanksWork::so_far(ranks, self.threads);
        self.report.add_checkpoint(Checkpoint::so_far(ranks));
        progress.clear();
        if let Some(file) = report_file {
            file.write(|writer| Ok(serde_json::to_writer_pretty(writer, &self.report)?))?;
        }
        if !progress.quiet {
            console::tell(&self.lines(written), ranks);
        }
        match self.solved.achieved {
            Some(achieved) if !is_saved && self.solved.outcome.converged && !achieved.reached() => {
                Err(CliError::Missed { estimate: achieved.estimate })
            }
            _ => match &self.report.checked {
                Some(checked) if *is_strict && checked.finds_more() => {
                    Err(CliError::FoundMore { what: "the light is", told: checked.own_error })
                }
                _ => Ok(()),
            },
        }
    }
}
