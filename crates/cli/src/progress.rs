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

/// Time after which a bar is drawn again that nothing has moved. Chosen.
const TICK: Duration = Duration::from_millis(500);

/// Lines of stages of which parts are counted, and of others.
const COUNTED: &str = "{msg:12} [{bar:30}] {human_pos}/{human_len} {per_sec} {eta} left{prefix}";
const UNCOUNTED: &str = "{msg:12} {elapsed}{prefix}";

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
        let mut ledger = Ledger::since(started);
        ledger.enter(None);
        Progress {
            bar: ProgressBar::with_draw_target(Some(0), target),
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
        if self.bar.is_finished() || self.bar.message() != stage {
            self.begin_line(COUNTED, stage);
        }
        let whole = self.whole.lock().unwrap_or_else(PoisonError::into_inner);
        self.bar.set_prefix(format!("{remark}{whole}"));
        self.bar.set_length(total);
        self.bar.set_position(done);
    }

    /// Begins the line of a stage.
    fn begin_line(&self, template: &str, stage: &'static str) {
        let style = ProgressStyle::with_template(template).expect("the template is correct");
        self.bar.set_style(style.progress_chars("=> "));
        self.bar.reset();
        self.bar.set_message(stage);
    }

    /// Shows the stage that runs, from time to time also while nothing of it is counted; nothing while none runs, as
    /// tables may be written.
    fn show_running(&self) {
        let running = self.ledger().running();
        match running.filter(|_| !self.bar.is_hidden()) {
            Some(stage) => {
                self.begin_line(UNCOUNTED, stage.name());
                self.bar.enable_steady_tick(TICK);
            }
            None => self.clear(),
        }
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
        self.bar.disable_steady_tick();
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
            Event::Began { stage } => {
                self.ledger().begin(stage);
                self.show_running();
            }
            Event::Ended { stage } => {
                let took = self.ledger().end(stage);
                self.show_running();
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
