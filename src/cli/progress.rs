//! A bar on stderr for long work: stage, done and total, time left.

use std::{
    io::{IsTerminal, stderr},
    time::Duration,
};

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
        let style = ProgressStyle::with_template("{msg:12} [{bar:30}] {human_pos}/{human_len} {eta} left")
            .expect("the template is correct")
            .progress_chars("=> ");
        Progress { bar: ProgressBar::with_draw_target(Some(0), target).with_style(style) }
    }

    /// Starts a stage of `total` steps.
    pub(crate) fn stage(&self, name: &'static str, total: u64) {
        self.bar.reset();
        self.bar.set_message(name);
        self.bar.set_length(total);
        self.bar.enable_steady_tick(Duration::from_millis(200));
    }

    /// Sets how many steps of the stage are done; may be called from any thread.
    pub(crate) fn done(&self, steps: u64) {
        self.bar.set_position(steps);
    }
}

impl Drop for Progress {
    /// Takes the bar away: what stays on the screen is the summary.
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
