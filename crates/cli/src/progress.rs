//! A bar on stderr for long work: stage, done and total, rate, time left.

use std::io::{IsTerminal, Write, stderr};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use radiosity_output::drawings::nice_numbers::round_above;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Machine, Observer, Progress as Event, Stage};

use crate::ledger::Ledger;
use crate::options::ReportArgs;

/// A progress bar; silent if stderr is not a terminal or the user wants quiet. It has no colours.
#[derive(Debug)]
pub(crate) struct Progress {
    bar: ProgressBar,
    /// Whether nothing is told.
    pub(crate) quiet: bool,
    /// Whether finished stages are told.
    pub(crate) verbose: bool,
    /// Threads that work.
    threads: usize,
    /// Words at the end of every line.
    whole: Mutex<String>,
    ledger: Mutex<Ledger>,
}

/// Seconds from which waiting is announced. Chosen.
const LONG: f64 = 1.0;

impl Progress {
    /// A bar of a run on so many threads (0: all) that began at this instant with what is done by now, which shows
    /// nothing yet; on the first of these ranks only.
    pub(crate) fn new(quiet: bool, threads: usize, started: Instant, ranks: &Ranks) -> Self {
        Self::telling(quiet, false, threads, started, ranks)
    }

    /// A bar with the messages that `report` asks for.
    pub(crate) fn of(report: &ReportArgs, threads: usize, started: Instant, ranks: &Ranks) -> Self {
        Self::telling(report.quiet, report.verbose, threads, started, ranks)
    }

    fn telling(quiet: bool, verbose: bool, threads: usize, started: Instant, ranks: &Ranks) -> Self {
        let quiet = quiet || !ranks.is_first();
        let shown = !quiet && stderr().is_terminal();
        let target =
            if shown { ProgressDrawTarget::stderr_with_hz(10) } else { ProgressDrawTarget::hidden() };
        let style = ProgressStyle::with_template(
            "{msg:12} [{bar:30}] {human_pos}/{human_len} {per_sec} {eta} left{prefix}",
        )
        .expect("the template is correct")
        .progress_chars("=> ");
        let mut ledger = Ledger::since(started);
        ledger.enter(None);
        Progress {
            bar: ProgressBar::with_draw_target(Some(0), target).with_style(style),
            quiet,
            verbose,
            threads: ranks.threads(threads),
            whole: Mutex::default(),
            ledger: Mutex::new(ledger),
        }
    }

    /// The ledger of the run.
    pub(crate) fn ledger(&self) -> MutexGuard<'_, Ledger> {
        self.ledger.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes that what is done from now on in no other stage is for files.
    pub(crate) fn begin_output(&self) {
        self.ledger().enter(Some(Stage::Output));
    }

    /// The line of a summary on the stages of the run.
    pub(crate) fn stages(&self) -> String {
        let machine = Machine::of(self.threads);
        self.ledger().line(self.verbose, &machine)
    }

    /// Shows that `done` of `total` steps of a stage are done; may be called from any thread.
    pub(crate) fn show(&self, stage: &'static str, done: usize, total: usize) {
        self.show_with(stage, "", done as u64, total as u64);
    }

    /// Shows that `done` of `total` rays are sent, and the error that they leave so far.
    fn show_rays(&self, done: u64, total: u64, error: Option<f64>) {
        let error = error.map(|error| format!(", error so far {error:.1e}"));
        self.show_with("rays", &error.unwrap_or_default(), done, total);
    }

    /// Ends every line from now on with words on the whole of which stages are a part.
    pub(crate) fn say_whole(&self, whole: String) {
        *self.whole.lock().unwrap_or_else(PoisonError::into_inner) = whole;
    }

    /// Shows a stage, with a remark at the end of the line.
    fn show_with(&self, stage: &'static str, remark: &str, done: u64, total: u64) {
        if self.bar.message() != stage {
            self.bar.reset();
            self.bar.set_message(stage);
        }
        let whole = self.whole.lock().unwrap_or_else(PoisonError::into_inner);
        self.bar.set_prefix(format!("{remark}{whole}"));
        self.bar.set_length(total);
        self.bar.set_position(done);
    }

    /// Seconds by the clock of the threads of this run for a forecast.
    pub(crate) fn seconds(&self, forecast: f64) -> f64 {
        Machine::of(self.threads).seconds(forecast)
    }

    /// Announces, also without a terminal, about how long a stage with this forecast will take, where that is long.
    fn expect(&self, stage: Stage, forecast: f64) {
        self.ledger().expect(stage, forecast);
        self.announce(stage.name(), self.seconds(forecast));
    }

    /// Announces, also without a terminal, about how many seconds something will take, where that is long.
    pub(crate) fn announce(&self, what: &str, seconds: f64) {
        if !self.quiet && seconds >= LONG {
            self.write(format!("{what}: about {} s\n", round_above(seconds)));
        }
    }

    /// Writes a line about a finished stage, also without a terminal.
    fn tell(&self, stage: Stage, took: Duration) {
        if !self.quiet {
            self.write(format!("{stage}: {:.3} s\n", took.as_secs_f64()));
        }
    }

    /// Removes the bar, so that only the summary stays on the screen.
    pub(crate) fn clear(&self) {
        self.bar.finish_and_clear();
    }

    fn write(&self, line: String) {
        // A closed stderr is no error: nobody would see a message.
        self.bar.suspend(|| drop(stderr().write_all(line.as_bytes())));
    }
}

impl Observer for Progress {
    fn report(&self, event: Event) {
        match event {
            Event::Expected { stage, seconds } => self.expect(stage, seconds),
            Event::Done { stage, done, of } => self.show(stage.name(), done, of),
            Event::Rays { done, of, error } => self.show_rays(done, of, error),
            Event::Iteration { band, of, .. } => self.show(Stage::Solve.name(), band, of),
            Event::Began { stage } => self.ledger().begin(stage),
            Event::Ended { stage } => {
                let took = self.ledger().end(stage);
                took.into_iter().filter(|_| self.verbose).for_each(|took| self.tell(stage, took));
            }
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.clear();
    }
}
