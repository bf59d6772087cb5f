//! A bar on stderr for long work: stage, done and total, rate, time left.

use std::io::{IsTerminal, Write, stderr};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A progress bar; silent if stderr is not a terminal or the user wants quiet. It has no colours, so that there is
/// nothing for `NO_COLOR` to take away.
#[derive(Debug)]
pub(crate) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar that shows nothing yet.
    pub(crate) fn new(quiet: bool) -> Self {
        let shown = !quiet && stderr().is_terminal();
        let target =
            if shown { ProgressDrawTarget::stderr_with_hz(10) } else { ProgressDrawTarget::hidden() };
        let style =
            ProgressStyle::with_template("{msg:12} [{bar:30}] {human_pos}/{human_len} {per_sec} {eta} left")
                .expect("the template is correct")
                .progress_chars("=> ");
        Progress { bar: ProgressBar::with_draw_target(Some(0), target).with_style(style) }
    }

    /// Shows that `done` of `total` steps of a stage are done; may be called from any thread.
    pub(crate) fn show(&self, stage: &'static str, done: usize, total: usize) {
        if self.bar.message() != stage {
            self.bar.reset();
            self.bar.set_message(stage);
        }
        self.bar.set_length(total as u64);
        self.bar.set_position(done as u64);
    }

    /// Writes a line about a stage that is done, terminal or not.
    pub(crate) fn tell(&self, stage: &str, took: Duration) {
        let line = format!("{stage}: {:.3} s\n", took.as_secs_f64());
        // Nobody is left to tell if stderr is closed.
        self.bar.suspend(|| drop(stderr().write_all(line.as_bytes())));
    }
}

impl Drop for Progress {
    /// Takes the bar away: what stays on the screen is the summary.
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
