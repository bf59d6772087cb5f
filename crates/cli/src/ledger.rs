//! The ledger of a run: the seconds of its stages.
//!
//! Time counts for the stage that began last and has not ended, each moment for one; what lies in none counts for the
//! part of the run that was entered last: the reading of its scene, then nothing, then what is made for its files.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use radiosity_reading::report::Seconds;
use radiosity_work::digits::significant;
use radiosity_work::{Machine, Stage};

/// Part of the whole below which the stages of a line are told together. Chosen.
const SMALL: f64 = 0.02;

/// The seconds of the stages of a run.
#[derive(Debug)]
pub(crate) struct Ledger {
    started: Instant,
    /// Until then all time is in the books.
    booked: Instant,
    /// The part of the run that was entered last.
    part: Option<Stage>,
    /// The stages that began and have not ended.
    running: Vec<RunningStage>,
    /// The stages in the order in which they began first, with their time.
    stages: Vec<(Stage, Duration)>,
    /// Forecasts of stages.
    forecasts: BTreeMap<Stage, f64>,
}

/// A stage that began and has not ended.
#[derive(Debug)]
struct RunningStage {
    stage: Stage,
    began: Instant,
}

impl Ledger {
    /// The ledger of a run that began at this instant with the reading of its scene.
    pub(crate) fn since(started: Instant) -> Self {
        Self {
            started,
            booked: started,
            part: Some(Stage::Load),
            running: Vec::new(),
            stages: vec![(Stage::Load, Duration::ZERO)],
            forecasts: BTreeMap::new(),
        }
    }

    /// Books the time from now on that is in no stage for this part of the run, if it has a name.
    pub(crate) fn enter(&mut self, part: Option<Stage>) {
        self.book();
        self.part = part;
    }

    /// Adds to the forecast of a stage.
    pub(crate) fn expect(&mut self, stage: Stage, forecast: f64) {
        *self.forecasts.entry(stage).or_default() += forecast;
    }

    /// The forecast of a stage.
    pub(crate) fn forecast(&self, stage: Stage) -> f64 {
        self.forecasts.get(&stage).copied().unwrap_or(0.0)
    }

    /// Begins a stage.
    pub(crate) fn begin(&mut self, stage: Stage) {
        self.book();
        self.running.push(RunningStage { stage, began: self.booked });
    }

    /// The stage that began last and has not ended.
    pub(crate) fn running(&self) -> Option<Stage> {
        self.running.last().map(|own| own.stage)
    }

    /// Ends a stage; its time, where it lay in no other.
    pub(crate) fn end(&mut self, stage: Stage) -> Option<Duration> {
        self.book();
        let place = self.running.iter().rposition(|own| own.stage == stage)?;
        let began = self.running[place].began;
        self.running.truncate(place);
        self.running.is_empty().then(|| self.booked - began)
    }

    /// Books the time that has passed.
    fn book(&mut self) {
        let now = Instant::now();
        let passed = now - std::mem::replace(&mut self.booked, now);
        let Some(stage) = self.running.last().map(|own| own.stage).or(self.part) else { return };
        match self.stages.iter_mut().find(|(own, _)| *own == stage) {
            Some((_, time)) => *time += passed,
            None => self.stages.push((stage, passed)),
        }
    }

    /// Seconds since the run began.
    pub(crate) fn seconds(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }

    /// The stages so far with their seconds.
    pub(crate) fn stages(&mut self) -> impl Iterator<Item = (Stage, f64)> {
        self.book();
        self.stages.iter().map(|(stage, time)| (*stage, time.as_secs_f64()))
    }

    /// The seconds of the stages, those of every solution also where they are none.
    pub(crate) fn report(&mut self) -> Seconds {
        let always = [
            Stage::Visibility,
            Stage::Elements,
            Stage::Direct,
            Stage::Blocks,
            Stage::Solve,
            Stage::Estimate,
            Stage::Output,
        ];
        let mut stages: BTreeMap<_, _> = always.map(|stage| (stage.name(), 0.0)).into();
        stages.extend(self.stages().map(|(stage, seconds)| (stage.name(), seconds)));
        Seconds { stages, total: self.seconds() }
    }

    /// A line on the stages, with their forecasts in seconds of a machine; the small ones together with what lies in
    /// none, or, where `all` are told, all of them.
    pub(crate) fn line(&mut self, all: bool, machine: &Machine) -> String {
        let whole = self.seconds();
        let least = if all { 0.0 } else { SMALL * whole };
        let forecasts = self.forecasts.clone();
        let told = |stage: &Stage| forecasts.get(stage).map(|&forecast| machine.seconds(forecast));
        let is_large = |(stage, seconds): &(Stage, f64)| seconds.max(told(stage).unwrap_or(0.0)) >= least;
        let large: Vec<(Stage, f64)> = self.stages().filter(is_large).collect();
        let rest = whole - large.iter().map(|(_, seconds)| seconds).sum::<f64>();
        let named = large.iter().map(|(stage, seconds)| match told(stage) {
            Some(told) => format!("{stage} {seconds:.3} s (forecast {} s)", significant(told, 2)),
            None => format!("{stage} {seconds:.3} s"),
        });
        let named: Vec<String> = named.chain([format!("other {:.3} s", rest.max(0.0))]).collect();
        format!("stages: {}", named.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use std::thread::sleep;

    use super::*;

    const LONG: Duration = Duration::from_millis(20);

    /// Every stage has at least the time that was slept in it, and no moment counts twice.
    #[test]
    fn time_counts_for_the_innermost_stage_and_once() {
        let begun = Instant::now();
        let mut ledger = Ledger::since(begun);
        sleep(LONG);
        ledger.enter(None);
        sleep(LONG);
        ledger.begin(Stage::Solve);
        sleep(LONG);
        ledger.begin(Stage::Blocks);
        sleep(2 * LONG);
        assert_eq!(ledger.end(Stage::Blocks), None, "it lay in another");
        sleep(LONG);
        assert!(ledger.end(Stage::Solve).is_some_and(|took| took >= 4 * LONG));
        ledger.enter(Some(Stage::Output));
        sleep(LONG);
        let stages: Vec<(Stage, f64)> = ledger.stages().collect();
        let whole = begun.elapsed().as_secs_f64();
        let least = [(Stage::Load, 1), (Stage::Solve, 2), (Stage::Blocks, 2), (Stage::Output, 1)];
        for ((stage, seconds), (expected, times)) in stages.iter().zip(least) {
            assert_eq!(*stage, expected);
            assert!(*seconds >= f64::from(times) * LONG.as_secs_f64(), "{stages:?}");
        }
        let sum: f64 = stages.iter().map(|(_, seconds)| seconds).sum();
        assert!(sum <= whole - LONG.as_secs_f64(), "{sum} of {whole}: what lay in no stage counts for none");
    }

    #[test]
    fn small_stages_are_told_together() {
        let mut ledger = Ledger::since(Instant::now());
        ledger.enter(None);
        ledger.begin(Stage::Solve);
        sleep(LONG);
        ledger.end(Stage::Solve);
        let machine = Machine::of(1);
        let [short, whole] = [false, true].map(|all| ledger.line(all, &machine));
        assert!(short.starts_with("stages: solve 0.0") && short.contains(", other 0.0"), "{short}");
        assert!(whole.starts_with("stages: load 0.000 s, solve 0.0"), "{whole}");
        // What was told is told again, also of what took nothing.
        ledger.expect(Stage::Load, machine.forecast(3.0));
        ledger.expect(Stage::Load, machine.forecast(0.5));
        let told = ledger.line(false, &machine);
        assert!(told.starts_with("stages: load 0.000 s (forecast 3.5 s), solve 0.0"), "{told}");
    }
}
