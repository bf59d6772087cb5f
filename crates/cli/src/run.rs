//! The run of every verb that needs light: it solves first, with progress and a report.

use std::fmt::Debug;
use std::path::{Path, PathBuf};
use std::time::Instant;

use radiosity_language::Import;
use radiosity_published::bases::Basis;
use radiosity_published::hierarchy::Counts;
use radiosity_reading::checkpoint::Checkpoint;
use radiosity_reading::digits::decimals;
use radiosity_reading::files::solution_file::{is_solution, read};
use radiosity_reading::plane_figures::PlaneFigures;
use radiosity_reading::probe::Probe;
use radiosity_reading::rank_work::RanksWork;
use radiosity_reading::read_error::ReadError;
use radiosity_reading::report::Report;
use radiosity_reading::warning::Warning;
use radiosity_request::MethodRequest;
use radiosity_request::aim::at_probes;
use radiosity_scene::{LightGroup, Scene};
use radiosity_solve::checks::Checks;
use radiosity_solve::gather::gather_method::GatherMethod;
use radiosity_solve::solved::Solved;
use radiosity_solve::studies::adaptation::{Achieved, Aim, Goal};
use radiosity_solve::{Functional, Options, Outcome, in_threads};
use radiosity_work::Work;
use radiosity_work::ranks::Ranks;

use crate::aim::wanted;
use crate::console;
use crate::error::CliError;
use crate::options::{ReportArgs, SceneArg, borrowed};
use crate::output_file::OutputFile;
use crate::progress::Progress;

/// The scene of a verb as it was read, solved or not.
///
/// A verb that solves takes [`Loaded::lit`], one that also reads solutions [`Loaded::readable`]. It checks
/// its own arguments against [`Loaded::scene`], and then hands all of it to [`Run::solve`].
#[derive(Debug)]
pub(crate) struct Loaded {
    /// The scene.
    pub(crate) scene: Scene,
    /// The file it was read from.
    file: Option<PathBuf>,
    /// Its solution, where a solution file was read.
    saved: Option<Saved>,
    /// When its reading began.
    started: Instant,
    seconds: f64,
}

/// Content of a solution file besides the scene.
#[derive(Debug)]
struct Saved {
    options: Options,
    outcome: Outcome,
    achieved: Option<Achieved>,
}

impl Saved {
    /// The solved scene again.
    fn with(self, scene: Scene) -> Solved {
        Solved::of(scene, self.options, self.outcome, self.achieved)
    }
}

impl Loaded {
    /// Reads a scene that has light.
    pub(crate) fn lit(source: &SceneArg, ranks: &Ranks) -> Result<Self, CliError> {
        let started = Instant::now();
        Self::new(source.path(), source.request().load_lit(ranks)?, None, started).required()
    }

    /// Reads a scene that has light, or a solution file; with a solution file the options in `fixed`, which
    /// were typed and change the method, are refused.
    pub(crate) fn readable(source: &SceneArg, fixed: &[String], ranks: &Ranks) -> Result<Self, CliError> {
        Self::dark_or_lit(source, fixed, ranks)?.required()
    }

    /// Reads a scene, dark or lit, or a solution file as [`Loaded::readable`] does.
    pub(crate) fn dark_or_lit(source: &SceneArg, fixed: &[String], ranks: &Ranks) -> Result<Self, CliError> {
        let started = Instant::now();
        let request = source.request();
        let text = request.text(ranks)?;
        if !is_solution(&text.text()) {
            let scene = request.parse(&text, ranks)?;
            return Ok(Self::new(source.path(), scene, None, started));
        }
        let tolerance = source.tolerance_length.map(|_| "--tolerance-length".to_owned());
        let frame = source.frame.map(|_| "--frame".to_owned());
        if let Some(option) = fixed.first().or(tolerance.as_ref()).or(frame.as_ref()) {
            return Err(CliError::Fixed { origin: text.origin.to_string(), option: option.clone() });
        }
        Ok(Self::saved(source.path(), relit(read(&text, ranks)?, &request.later())?, started))
    }

    /// Reads a solution file, with its light groups at the factors that were set.
    pub(crate) fn solved(path: &str, settings: &[(String, f64)], ranks: &Ranks) -> Result<Self, CliError> {
        let started = Instant::now();
        let source = radiosity_language::source_by(path, &[], &Import::default(), ranks)?;
        if !is_solution(&source.text()) {
            return Err(CliError::NotSolved { origin: source.origin.to_string() });
        }
        let file = (path != "-").then(|| Path::new(path));
        Self::saved(file, relit(read(&source, ranks)?, &borrowed(settings))?, started).required()
    }

    fn saved(file: Option<&Path>, solved: Solved, started: Instant) -> Self {
        let Solved { scene, options, outcome, achieved, .. } = solved;
        Self::new(file, scene, Some(Saved { options, outcome, achieved }), started)
    }

    fn new(file: Option<&Path>, scene: Scene, saved: Option<Saved>, started: Instant) -> Self {
        let file = file.map(Path::to_owned);
        Self { scene, file, saved, started, seconds: started.elapsed().as_secs_f64() }
    }

    /// Refuses a scene without light.
    pub(crate) fn required(self) -> Result<Self, CliError> {
        self.scene.require_light()?;
        Ok(self)
    }

    /// The options that the scene was or will be solved with.
    pub(crate) fn options(&self, method: &MethodRequest, ranks: &Ranks) -> Options {
        self.saved.as_ref().map_or_else(|| options(method, ranks), |saved| saved.options)
    }

    /// All inputs on which results depend besides the command line.
    pub(crate) fn content(&self) -> impl Debug {
        let saved = self.saved.as_ref();
        (&self.scene, saved.map(|saved| (saved.options.neutral(), &saved.outcome, &saved.achieved)))
    }

    /// Finds out, before the work, whether `output` can be written, and is neither the input nor the report.
    pub(crate) fn reserve(
        &self,
        output: &Path,
        report: &ReportArgs,
        ranks: &Ranks,
    ) -> Result<OutputFile, CliError> {
        let output = self.apart(OutputFile::reserve(output, ranks)?)?;
        match &report.report {
            Some(report) => output.apart_from(report, "the report"),
            None => Ok(output),
        }
    }

    /// `output`, if it is not the file of the scene.
    pub(crate) fn apart(&self, output: OutputFile) -> Result<OutputFile, CliError> {
        match &self.file {
            Some(file) => output.apart_from(file, "the scene"),
            None => Ok(output),
        }
    }
}

/// The solution with its light groups at these factors.
fn relit(solved: Solved, factors: &[(&str, f64)]) -> Result<Solved, CliError> {
    if factors.is_empty() { Ok(solved) } else { Ok(solved.relight(factors)?) }
}

/// Most remarks on a scene of another program that a summary spells out. Chosen.
const SPELT: usize = 12;

/// Remarks on the changes to a scene of another program when it was read.
pub(crate) fn remarks(scene: &Scene) -> Vec<String> {
    let all: Vec<String> = scene.imported().map(|imported| imported.lines().collect()).unwrap_or_default();
    let count = all.len();
    if count <= SPELT {
        return all;
    }
    let rest = format!("{} more remarks: `radiosity check` and --report say them all", count - SPELT + 1);
    all.into_iter().take(SPELT - 1).chain([rest]).collect()
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
    ranks: Ranks,
    report: Report,
    report_file: Option<OutputFile>,
    quiet: bool,
    verbose: bool,
    /// Whether the solution was read from a file.
    saved: bool,
    started: Instant,
    ready: Instant,
}

/// Figures of a run that are known before it solves.
struct RunStart {
    threads: usize,
    ranks: Ranks,
    /// Whether the solution was read from a file.
    is_saved: bool,
    started: Instant,
    /// Seconds of reading.
    seconds: f64,
    report_file: Option<OutputFile>,
}

impl RunStart {
    /// The start of a run on a loaded scene; finds out whether the report can be written.
    fn of(loaded: &Loaded, threads: usize, report: &ReportArgs, ranks: &Ranks) -> Result<Self, CliError> {
        let report_file = report.reserve(ranks)?.map(|file| loaded.apart(file)).transpose()?;
        let Loaded { saved, started, seconds, .. } = loaded;
        Ok(Self {
            threads: ranks.threads(threads),
            ranks: ranks.clone(),
            is_saved: saved.is_some(),
            started: *started,
            seconds: *seconds,
            report_file,
        })
    }
}

impl Run {
    /// Solves the scene, unless its solution was read.
    pub(crate) fn solve(
        loaded: Loaded,
        method: &MethodRequest,
        report: &ReportArgs,
        work: &Work<'_>,
    ) -> Result<Self, CliError> {
        Self::with_options(loaded, method, options(method, work.ranks), report, work)
    }

    /// Solves as [`Run::solve`], for light that is then gathered by cells or rays.
    pub(crate) fn to_gather(
        loaded: Loaded,
        method: &MethodRequest,
        by: GatherMethod,
        report: &ReportArgs,
        work: &Work<'_>,
    ) -> Result<Self, CliError> {
        let goal = wanted(method, &loaded.scene, work.ranks)?.map(|goal| goal.read_by(by));
        Self::to(goal, loaded, method, options(method, work.ranks), report, work)
    }

    /// Solves as [`Run::to_gather`]; where an accuracy is wanted and nothing says of what, it is that of the
    /// light at these sensors.
    pub(crate) fn for_sensors(
        loaded: Loaded,
        sensors: &[Probe],
        method: &MethodRequest,
        by: GatherMethod,
        report: &ReportArgs,
        work: &Work<'_>,
    ) -> Result<Self, CliError> {
        let goal = match (&method.aim, method.wanted_accuracy()) {
            (None, Some(accuracy)) => Some(at_probes(accuracy, sensors, &loaded.scene)),
            _ => wanted(method, &loaded.scene, work.ranks)?,
        };
        let asked = options(method, work.ranks);
        Self::to(goal.map(|goal| goal.read_by(by)), loaded, method, asked, report, work)
    }

    /// As [`Run::solve`], with options that no longer follow from the command line alone.
    pub(crate) fn with_options(
        loaded: Loaded,
        method: &MethodRequest,
        asked: Options,
        report: &ReportArgs,
        work: &Work<'_>,
    ) -> Result<Self, CliError> {
        let goal = wanted(method, &loaded.scene, work.ranks)?;
        Self::to(goal, loaded, method, asked, report, work)
    }

    /// Solves until the goal is reached, if there is one.
    fn to(
        goal: Option<Goal>,
        loaded: Loaded,
        method: &MethodRequest,
        asked: Options,
        report: &ReportArgs,
        work: &Work<'_>,
    ) -> Result<Self, CliError> {
        method.check()?;
        let start = RunStart::of(&loaded, asked.threads, report, work.ranks)?;
        let scene = loaded.scene;
        let solved = match (loaded.saved, goal) {
            (Some(saved), _) => saved.with(scene),
            (None, Some(goal)) => Solved::to_accuracy(scene, &asked, &goal, work)?,
            (None, None) => Solved::new(scene, asked, work)?,
        };
        Ok(Self::new(solved, start, report))
    }

    /// Takes a solution file as it was read.
    pub(crate) fn read(loaded: Loaded, report: &ReportArgs, ranks: &Ranks) -> Result<Self, CliError> {
        let start = RunStart::of(&loaded, 0, report, ranks)?;
        let saved = loaded.saved.expect("a solution file was read");
        Ok(Self::new(saved.with(loaded.scene), start, report))
    }

    fn new(solved: Solved, start: RunStart, report: &ReportArgs) -> Self {
        let RunStart { threads, ranks, is_saved, started, seconds, report_file } = start;
        let mut summary = Report::new(&solved, threads);
        summary.seconds.load = seconds;
        Self {
            solved,
            threads,
            ranks,
            saved: is_saved,
            report: summary,
            report_file,
            quiet: report.quiet,
            verbose: report.verbose,
            started,
            ready: Instant::now(),
        }
    }

    /// Whether the solution was read from a file.
    pub(crate) fn is_saved(&self) -> bool {
        self.saved
    }

    /// Runs long work with as many threads as were asked for.
    pub(crate) fn in_threads<T: Send>(&self, work: impl FnOnce() -> T + Send) -> Result<T, CliError> {
        Ok(in_threads(self.threads, work)?)
    }

    /// The report so far.
    pub(crate) fn report(&self) -> &Report {
        &self.report
    }

    /// Adds the figures of planes to the summary and to the report.
    pub(crate) fn add_planes(&mut self, planes: Vec<PlaneFigures>) {
        self.report.add_planes(planes);
    }

    /// Adds the errors of readings by rays that were to err by `asked`.
    pub(crate) fn add_read_error(&mut self, error: Option<ReadError>, asked: f64) {
        self.report.add_read_error(error, asked);
    }

    /// Ends the run: times the output, writes the summary to stderr, writes the report; fails where a wanted
    /// accuracy was not reached.
    pub(crate) fn finish(mut self, progress: Progress, written: Option<&str>) -> Result<(), CliError> {
        self.report.seconds.output = self.ready.elapsed().as_secs_f64();
        self.report.seconds.total = self.started.elapsed().as_secs_f64();
        self.report.ranks = RanksWork::so_far(&self.ranks, self.threads);
        self.report.add_checkpoint(Checkpoint::so_far(&self.ranks));
        drop(progress);
        if let Some(file) = &self.report_file {
            file.write(|writer| Ok(serde_json::to_writer_pretty(writer, &self.report)?))?;
        }
        if !self.quiet {
            self.tell(written);
        }
        match self.solved.achieved {
            Some(achieved) if !self.saved && self.solved.outcome.converged && !achieved.reached() => {
                Err(CliError::Missed { estimate: achieved.estimate })
            }
            _ => Ok(()),
        }
    }

    /// Aim of the estimated error, where there is one.
    fn aim(&self) -> Option<Aim> {
        self.solved.achieved.map(|achieved| achieved.of)
    }

    /// Name of the estimated error by its aim.
    fn estimated(&self) -> &'static str {
        match self.aim() {
            Some(Aim::Gathered) => "gathered light",
            Some(Aim::Points) => "light at the points",
            Some(Aim::Seen) => "light in the picture",
            Some(Aim::Solution) | None => "the radiosity",
        }
    }

    /// The line about time.
    fn costs(&self) -> String {
        let Report { seconds, solver, residual, .. } = &self.report;
        let (output, total) = (seconds.output, seconds.total);
        if self.saved {
            return format!(
                "solution read in {:.3} s ({solver}, residual {residual:.1e}), output {output:.3} s, all {total:.3} s",
                seconds.load
            );
        }
        let blocks = match (self.report.transport.links, self.report.transport.error) {
            (Some(counts), _) => {
                let Counts { nodes, links, cluster_links, rounds, .. } = counts;
                format!("{links} links between {nodes} nodes, {cluster_links} of clusters, {rounds} rounds")
            }
            (None, Some(error)) => {
                let rays = self.report.transport.rays as f64 / seconds.blocks.max(1e-9) / 1e6;
                let exact = match self.report.transport.exact_pairs {
                    0 => String::new(),
                    pairs => format!(" and {pairs} pairs exactly"),
                };
                format!(
                    "{} rays{exact}, {rays:.1} M/s, rays leave an error of {error:.1e}",
                    self.report.transport.rays
                )
            }
            (None, None) => {
                let Report { kernel_samples, shadow_rays, .. } = &self.report;
                format!("{kernel_samples} kernel samples, {shadow_rays} shadow rays")
            }
        };
        format!(
            "blocks {:.3} s ({blocks}), {solver} {:.3} s (residual {residual:.1e}), \
             output {output:.3} s, all {total:.3} s",
            seconds.blocks, seconds.solve
        )
    }

    /// The functions on the elements in words.
    fn functions(&self) -> String {
        match (self.solved.options.basis, self.report.orders) {
            (Basis::Constant, _) => "constants".to_owned(),
            (Basis::Linear, _) => "tents".to_owned(),
            (Basis::Harmonic, _) => format!("cosines of degree {}", self.report.order),
            (Basis::Legendre, [lowest, highest]) if lowest == highest => format!("order {lowest}"),
            (Basis::Legendre, [lowest, highest]) => format!("orders {lowest} to {highest}"),
        }
    }

    /// Words on the number of reflections that the light was limited to; empty without a limit.
    fn bounces(&self) -> String {
        let limited = |bounces: usize| format!("; light of {bounces} reflections at the most");
        self.solved.options.bounces.map_or_else(String::new, limited)
    }

    fn tell(&self, written: Option<&str>) {
        let Report { surfaces, elements, unknowns, checks, .. } = &self.report;
        let mut lines = vec![
            format!(
                "{}: {surfaces} surfaces, {elements} elements, {}, {unknowns} unknowns a band{}",
                self.report.scene,
                self.functions(),
                self.bounces()
            ),
            self.costs(),
        ];
        lines.extend(self.report.ranks.as_ref().map(RanksWork::to_string));
        lines.extend(self.report.checkpoint.as_ref().map(Checkpoint::to_string));
        lines.push(format!(
            "{}; row sums {} to {}",
            balance(checks),
            decimals(checks.row_sum_min, 4),
            decimals(checks.row_sum_max, 4)
        ));
        lines.extend(groups(&self.report.light_groups));
        lines.extend(remarks(&self.solved.scene));
        lines.extend(self.solved.scene.fitted.line());
        // The error that rays leave in the radiosity of elements is told with the blocks.
        let is_told = self.report.transport.kind != "exact" && self.aim() == Some(Aim::Solution);
        let estimate = self.report.accuracy_estimate.filter(|_| !is_told);
        lines.extend(
            estimate
                .map(|estimate| format!("estimated relative error of {} {estimate:.1e}", self.estimated())),
        );
        lines.extend(self.report.read_error.map(|error| error.to_string()));
        if self.verbose {
            lines.extend(self.report.functionals.iter().map(minimum));
            lines.push(format!("pairs: {:?}", self.report.pairs));
            lines.push(format!(
                "closure {:.2e}, spectral bound {:.4}, largest seam jump {:.2e}",
                checks.closure_max, checks.spectral_bound, checks.seam_jump_max
            ));
        }
        lines.extend(self.report.planes.iter().flat_map(|plane| plane.lines(&self.report.unit)));
        lines.extend(self.report.warnings.iter().map(Warning::to_string));
        lines.extend(written.map(|path| format!("wrote {path}")));
        console::tell(&(lines.join("\n") + "\n"), &self.ranks);
    }
}

/// The line about the least value of the variational functional.
fn minimum(Functional { band, group, value }: &Functional) -> String {
    let group = group.as_ref().map_or_else(String::new, |group| format!(", light group '{group}'"));
    format!("variational functional of band '{band}'{group}: {value:.9e}")
}

/// The line about the balance of power.
fn balance(checks: &Checks) -> String {
    if checks.energy_in == 0.0 {
        return "all lights are off".to_owned();
    }
    format!(
        "of the emitted power {} % is absorbed, {} % lost",
        decimals(100.0 * checks.energy_absorbed / checks.energy_in, 2),
        decimals(100.0 * checks.energy_lost / checks.energy_in, 2)
    )
}

/// The line about light groups, where there are any.
fn groups(groups: &[LightGroup]) -> Option<String> {
    let list: Vec<String> = groups.iter().map(|group| format!("{} × {}", group.name, group.factor)).collect();
    (!list.is_empty()).then(|| format!("light groups: {}", list.join(", ")))
}

/// The library's options of a method as typed, on these ranks.
pub(crate) fn options(method: &MethodRequest, ranks: &Ranks) -> Options {
    method.options(ranks)
}
