//! The check of what a run prints: once, by a referee.

use radiosity_audit::{Checked, Referee};
use radiosity_reading::checked_readings::{CheckEffort, CheckedReadings, PrintedReading};
use radiosity_reading::judging::JudgedRun;
use radiosity_reading::quality::ReadSettings;
use radiosity_reading::reader::ReadMode;
use radiosity_reading::run_cost::seconds_to_read;
use radiosity_work::Stage;

use super::Run;
use crate::error::CliError;

impl Run {
    /// The check of `count` printed numbers that `reading` gives, which took about so many seconds to read;
    /// None where a referee does not know such light.
    pub(crate) fn check(
        &self,
        count: usize,
        reading: impl Fn(usize) -> Option<PrintedReading> + Send,
        seconds: f64,
    ) -> Result<Option<CheckedReadings>, CliError> {
        let Some(effort) = self.check_effort(seconds, count) else { return Ok(None) };
        let referee = || Referee::of_light(&self.solved.scene);
        let judge = || CheckedReadings::of(&referee(), count, reading, &effort, &self.work());
        let judge = || self.work().during(Stage::Referee, judge);
        Ok(Some(self.in_threads(judge)?).filter(|checked| !checked.judged.is_empty()))
    }

    /// Checks the solution at places of its surfaces and planes as they are read with `settings`, where it is
    /// written for readers, and adds that to the summary and the report.
    pub(crate) fn check_solution(&mut self, settings: &ReadSettings) -> Result<(), CliError> {
        let Some(effort) = self.check_effort(0.0, usize::MAX) else { return Ok(()) };
        let referee = || Referee::of_light(&self.solved.scene);
        let judge = || JudgedRun::of_all_light(&self.solved, settings, &referee(), &effort, &self.work());
        let judged = self.in_threads(|| self.work().during(Stage::Referee, judge))?;
        self.add_checked((!judged.readings.is_empty()).then_some(judged.checked), settings.read);
        Ok(())
    }

    /// Adds what a check of light that was read from `read` found to the summary and the report.
    pub(crate) fn add_checked(&mut self, checked: Option<Checked>, read: ReadMode) {
        if let Some(checked) = checked {
            self.report.add_checked(checked, read);
        }
    }

    /// Seconds to read so many points with `settings`, by counts.
    pub(crate) fn seconds_to_read(&self, settings: &ReadSettings, points: usize) -> f64 {
        seconds_to_read(&self.solved, settings, points as f64)
    }

    /// The readings that are checked of so many numbers, after so many seconds of reading by their forecast, of which a
    /// time limit lets fewer be spent.
    fn check_effort(&self, seconds: f64, count: usize) -> Option<CheckEffort> {
        let limit = self.start.read_until.map(|ends| ends.saturating_duration_since(self.start.started));
        let seconds = limit.map_or(seconds, |limit| seconds.min(limit.as_secs_f64()));
        self.check.of_solution(&self.solved, self.is_saved(), seconds, count)
    }
}
