//! The check of what a run prints: once, by a referee.

use std::sync::atomic::Ordering;
use std::time::Instant;

use radiosity_audit::{Checked, Referee};
use radiosity_reading::checked_readings::{CheckEffort, CheckedReadings, PrintedReading};
use radiosity_reading::judging::JudgedRun;
use radiosity_reading::quality::ReadSettings;
use radiosity_reading::reader::ReadMode;
use radiosity_reading::run_cost::{seconds_to_read, tell_readings};
use radiosity_work::{Pace, Progress, Stage, Work};

use super::Run;
use crate::error::CliError;

/// Parts of the time left for a check in which light is read for it, and in which walks are made by their forecast;
/// what walks take longer, and their second look, have the rest. Chosen.
const READ: f64 = 0.4;
const WALKED: f64 = 0.3;

impl Run {
    /// The check of `count` printed numbers that `reading` gives, which took about so many seconds to read;
    /// None where a referee does not know such light, or has no time.
    pub(crate) fn check(
        &self,
        count: usize,
        reading: impl Fn(usize) -> Option<PrintedReading> + Send,
        seconds: f64,
    ) -> Result<Option<CheckedReadings>, CliError> {
        let Some(effort) = self.check_effort(seconds, count) else { return Ok(None) };
        self.tell_walks(&effort);
        let referee = || Referee::of_light(&self.solved.scene);
        let judge = || CheckedReadings::of(&referee(), count, reading, &effort, &self.check_work());
        let judge = || self.work().during(Stage::Referee, judge);
        let checked = self.in_threads(judge)?;
        self.note_unchecked(&checked.checked);
        Ok(Some(checked).filter(|checked| !checked.judged.is_empty()))
    }

    /// Checks the solution at places of its surfaces and planes as they are read with `settings`, where it is
    /// written for readers, and adds that to the summary and the report.
    pub(crate) fn check_solution(&mut self, settings: &ReadSettings) -> Result<(), CliError> {
        let Some(effort) = self.check_effort(0.0, usize::MAX) else { return Ok(()) };
        let pace = self
            .check_work()
            .left()
            .map(|left| Pace::of(effort.readings, self.threads, Instant::now() + left.mul_f64(READ)));
        let settings = pace.as_ref().map_or(*settings, |pace| self.paced(settings, pace));
        if pace.is_none() {
            let readings = effort.readings;
            tell_readings(&self.solved, &settings, readings, true, Stage::Referee, &self.work());
            self.tell_walks(&effort);
        }
        let judge = || {
            let referee = Referee::of_light(&self.solved.scene);
            let work = self.check_work();
            JudgedRun::of_all_light(&self.solved, &settings, pace.as_ref(), &referee, &effort, &work)
        };
        let judged = self.in_threads(|| self.work().during(Stage::Referee, judge))?;
        self.note_unchecked(&judged.checked);
        self.add_checked((!judged.readings.is_empty()).then_some(judged.checked), settings.read);
        Ok(())
    }

    /// Adds what a check of light that was read from `read` found to the summary and the report.
    pub(crate) fn add_checked(&mut self, checked: Option<Checked>, read: ReadMode) {
        if let Some(checked) = checked {
            self.report.add_checked(checked, read);
        }
    }

    /// Tells about how long so many readings of a stage take, unless their time is limited.
    pub(crate) fn tell_readings(&self, settings: &ReadSettings, readings: usize, stage: Stage) {
        if self.time_left().is_none() {
            tell_readings(&self.solved, settings, readings, false, stage, &self.work());
        }
    }

    /// Tells about how long the walks of a check take, unless their time is limited.
    fn tell_walks(&self, effort: &CheckEffort) {
        if self.time_left().is_none() {
            let seconds = effort.seconds(&self.solved.scene);
            self.work().report(Progress::Expected { stage: Stage::Referee, seconds });
        }
    }

    /// Seconds to read so many points with `settings`, by counts.
    pub(crate) fn seconds_to_read(&self, settings: &ReadSettings, points: usize) -> f64 {
        seconds_to_read(&self.solved, settings, points as f64)
    }

    /// Whether a check was left out because time was up.
    pub(super) fn is_unchecked(&self) -> bool {
        self.is_unchecked.load(Ordering::Relaxed)
    }

    /// The work of the check, which ends with the run.
    fn check_work(&self) -> Work<'_> {
        Work { deadline: self.start.limit.as_ref(), ..self.work() }
    }

    /// Notes a check that came to none of what was to be judged.
    fn note_unchecked(&self, checked: &Checked) {
        if checked.audit.readings == 0 && checked.audit.left_out > 0 {
            self.is_unchecked.store(true, Ordering::Relaxed);
        }
    }

    /// The readings that are checked of so many numbers, after so many seconds of reading by their forecast, of which a
    /// time limit lets fewer be spent; None also where time is up.
    fn check_effort(&self, seconds: f64, count: usize) -> Option<CheckEffort> {
        let limit = self.start.read_until.map(|ends| ends.saturating_duration_since(self.start.started));
        let seconds = limit.map_or(seconds, |limit| seconds.min(limit.as_secs_f64()));
        let work = self.check_work();
        let check = work.left().map_or(self.check, |left| self.check.within(WALKED * left.as_secs_f64()));
        let effort = check.of_solution(&self.solved, self.is_saved(), seconds, count)?;
        if work.is_late() {
            self.is_unchecked.store(true, Ordering::Relaxed);
            return None;
        }
        Some(effort)
    }
}
