//! What every verb that needs light does first: solve, with progress and a report.

use std::io::{Write, stderr};
use std::time::Instant;

use radiosity::elements::cells::Layers;
use radiosity::elements::space::Space;
use radiosity::output::report::Report;
use radiosity::scene::Scene;
use radiosity::solve::{self, Options, Outcome, Progress as Stage};

use crate::cli::error::CliError;
use radiosity::visibility;

use crate::cli::options::{MethodArgs, ReportArgs, SceneArg, Shadows, Subdivide};
use crate::cli::output_file::OutputFile;
use crate::cli::progress::Progress;

/// A scene just read.
#[derive(Debug)]
pub(crate) struct Loaded {
    /// The scene.
    pub(crate) scene: Scene,
    /// When its reading began.
    started: Instant,
    seconds: f64,
}

impl Loaded {
    /// Reads a scene that light can be asked of.
    pub(crate) fn lit(source: &SceneArg) -> Result<Self, CliError> {
        let started = Instant::now();
        let scene = source.load()?;
        scene.require_light()?;
        Ok(Self { scene, started, seconds: started.elapsed().as_secs_f64() })
    }
}

/// A solved scene with its report under way.
#[derive(Debug)]
pub(crate) struct Run {
    /// The solution and its figures.
    pub(crate) outcome: Outcome,
    /// Threads it was computed with.
    pub(crate) threads: usize,
    report: Report,
    report_file: Option<OutputFile>,
    quiet: bool,
    verbose: bool,
    started: Instant,
    solved: Instant,
}

impl Run {
    /// Solves the scene; the bar shows how far it is.
    pub(crate) fn solve(
        loaded: &Loaded,
        method: &MethodArgs,
        report: &ReportArgs,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        let report_file = report.reserve()?;
        let options = options(method);
        let observe = |stage| match stage {
            Stage::Blocks(done, total) => progress.show("blocks", done, total),
            Stage::Solve(band, _, _) => progress.show("solve", band, loaded.scene.bands.len()),
        };
        let outcome = solve::solve(&loaded.scene, &options, &observe)?;
        let mut summary = Report::new(&loaded.scene, &options, &outcome);
        summary.seconds.load = loaded.seconds;
        Ok(Self {
            outcome,
            threads: options.threads,
            report: summary,
            report_file,
            quiet: report.quiet,
            verbose: report.verbose,
            started: loaded.started,
            solved: Instant::now(),
        })
    }

    /// Ends the run: times the output, tells the summary on stderr, writes the report.
    pub(crate) fn finish(mut self, progress: Progress, written: Option<&str>) -> Result<(), CliError> {
        self.report.seconds.output = self.solved.elapsed().as_secs_f64();
        self.report.seconds.total = self.started.elapsed().as_secs_f64();
        drop(progress);
        if let Some(file) = &self.report_file {
            file.write(|writer| Ok(serde_json::to_writer_pretty(writer, &self.report)?))?;
        }
        if !self.quiet {
            self.tell(written);
        }
        Ok(())
    }

    fn tell(&self, written: Option<&str>) {
        let Report { surfaces, elements, unknowns, order, seconds, checks, .. } = &self.report;
        let mut lines = vec![
            format!(
                "{}: {surfaces} surfaces, {elements} elements, order {order}, {unknowns} unknowns a band",
                self.report.scene
            ),
            format!(
                "blocks {:.3} s ({} kernel samples, {} shadow rays), {} {:.3} s (residual {:.1e}), output {:.3} s, all {:.3} s",
                seconds.blocks,
                self.report.kernel_samples,
                self.report.shadow_rays,
                self.report.solver,
                seconds.solve,
                self.report.residual,
                seconds.output,
                seconds.total
            ),
            format!(
                "of the emitted power {:.2} % is absorbed, {:.2} % lost; row sums {:.4} to {:.4}",
                100.0 * checks.energy_absorbed / checks.energy_in,
                100.0 * checks.energy_lost / checks.energy_in,
                checks.row_sum_min,
                checks.row_sum_max
            ),
        ];
        if self.verbose {
            lines.push(format!("pairs: {:?}", self.report.pairs));
            lines.push(format!(
                "closure {:.2e}, spectral bound {:.4}, largest seam jump {:.2e}",
                checks.closure_max, checks.spectral_bound, checks.seam_jump_max
            ));
        }
        lines.extend(self.report.warnings.iter().map(|warning| format!("warning: {}", warning.message)));
        lines.extend(written.map(|path| format!("wrote {path}")));
        // Nobody is left to tell if stderr is closed.
        let _ = stderr().write_all((lines.join("\n") + "\n").as_bytes());
    }
}

/// Whether surfaces hide each other, as the solution was asked to see it.
pub(crate) fn shadows(method: &MethodArgs) -> visibility::Shadows {
    match method.shadows {
        Shadows::Off => visibility::Shadows::Off,
        Shadows::Auto | Shadows::Rays => visibility::Shadows::Rays(Options::default().shadow_eps),
    }
}

fn options(method: &MethodArgs) -> Options {
    let defaults = Options::default();
    Options {
        order: method.order,
        space: if method.tensor { Space::Tensor } else { Space::Total },
        subdivide: match method.subdivide {
            Subdivide::Auto => None,
            Subdivide::Parts(parts) => Some(parts),
        },
        layers: Layers { count: method.layers, ratio: method.ratio },
        eps: method.eps,
        kernel: method.kernel.rules(),
        closure: method.closure_correction,
        shadows: method.shadows != Shadows::Off,
        method: method.solver,
        tolerance: method.tolerance,
        max_iterations: method.max_iterations,
        threads: method.threads.unwrap_or(defaults.threads),
        ..defaults
    }
}
