//! Requests for a referee: how long it looks, and at how many readings.

use radiosity_audit::{Effort, HeatFault, WalkCost, evenly};
use radiosity_heat::Heat;
use radiosity_reading::checked_factors::CheckedFactors;
use radiosity_reading::checked_readings::CheckEffort;
use radiosity_scene::Scene;
use radiosity_solve::Options;
use radiosity_solve::solved::Solved;
use radiosity_solve::view_factors::{self, ViewFactors};
use radiosity_visibility::Shadows;
use radiosity_work::wording::{Wording, option, set, words};
use radiosity_work::{Progress, Stage, Work};
use serde::Deserialize;

use super::ranges::{Number, Readings, Seconds, Seed};
use super::refusal::Refusal;

/// Seconds of looking unless told otherwise. Chosen: most rooms then show errors of half a percent.
const SECONDS: f64 = 2.0;

/// Seed of the walks of a check: others than those by which an accuracy was judged.
const OF_CHECKS: u64 = 2;

/// Readings unless told otherwise. Chosen: an L2 mean of 64 is known to a tenth of itself.
const READINGS: usize = 64;

/// Options of a referee; None where nothing is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct AuditRequest {
    /// Seconds that about two threads take for its rays; their number follows from this and from counts of
    /// the scene, and is printed [default: 2]
    #[cfg_attr(feature = "clap", arg(long, value_name = "S", allow_negative_numbers = true))]
    pub seconds: Option<Number<Seconds>>,

    /// About the number of readings that are judged, of heat and view factors of surfaces at the most
    /// [default: 64]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", allow_negative_numbers = true))]
    pub readings: Option<Readings>,

    /// Chooses other places and other rays [default: 0]
    #[cfg_attr(feature = "clap", arg(long, value_name = "K", allow_negative_numbers = true))]
    pub seed: Option<Seed>,
}

/// Options of the referee beside a run; None where nothing is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct CheckRequest {
    /// Seconds that about two threads take to check what is printed by path tracing; the number of rays
    /// follows from this and from counts of the scene [default: a twentieth of the run, 0.1 to 5]
    #[cfg_attr(feature = "clap", arg(long, value_name = "SECONDS", allow_negative_numbers = true))]
    pub audit: Option<Number<Seconds>>,

    /// Most seconds that the check may take.
    #[serde(skip)]
    #[cfg_attr(feature = "clap", arg(skip))]
    pub most: Option<f64>,
}

impl CheckRequest {
    /// Numbers that are checked at the most. Chosen: an L2 mean of 64 is known to a tenth of itself.
    const READINGS: usize = READINGS;

    /// Refuses a check that was typed of light that a referee does not know.
    ///
    /// # Errors
    /// Where the light that these options find is not all light with its shadows.
    pub fn check(&self, options: &Options) -> Result<(), Refusal> {
        let Some(limit) = other_physics(options).filter(|_| self.audit.is_some()) else { return Ok(()) };
        Err(Refusal::new(
            limit.clone() + " finds other light than path tracing, which " + option("audit") + " asks for",
            words("leave out ") + option("audit") + ", or " + limit,
        ))
    }

    /// The readings that are checked of `count` numbers that are printed of a scene solved with these options,
    /// beside a run of about so many seconds, which follow from counts of its work; None where a referee does
    /// not know that light, or nothing emits.
    pub fn of_light(&self, run: f64, count: usize, scene: &Scene, options: &Options) -> Option<CheckEffort> {
        if other_physics(options).is_some() || scene.require_light().is_err() {
            return None;
        }
        let cost = WalkCost::of_light(scene);
        let readings = Effort::readings(self.seconds(run), Self::READINGS.min(count), &cost);
        let effort = self.effort(run, readings, &cost);
        (readings > 0).then_some(CheckEffort { readings, effort, seed: 0 })
    }

    /// The readings that are checked of `count` numbers that are printed of `solved`, whose reading took about
    /// `reading` seconds by counts, or which a file held; None also where the solver did not converge, which is told.
    pub fn of_solution(
        &self,
        solved: &Solved,
        is_saved: bool,
        reading: f64,
        count: usize,
    ) -> Option<CheckEffort> {
        let solving = if is_saved { 0.0 } else { solved.outcome.seconds_by_counts() };
        let effort = self.of_light(solving + reading, count, &solved.scene, &solved.options);
        effort.filter(|_| solved.outcome.converged)
    }

    /// Lets a referee make the errors of a balance true; not without `shadows`, which rays always see.
    ///
    /// # Errors
    /// Heat that no referee can read.
    pub fn check_heat(
        &self,
        heat: &mut Heat,
        scene: &Scene,
        shadows: Shadows,
        work: &Work<'_>,
    ) -> Result<(), HeatFault> {
        if shadows == Shadows::Off {
            return Ok(());
        }
        work.during(Stage::Referee, || {
            let (run, cost) = (heat.outcome.seconds_by_counts(), WalkCost::of_heat(scene));
            let surfaces = heat.to_check(scene, Effort::readings(self.seconds(run), Self::READINGS, &cost));
            let effort = self.effort(run, surfaces.len(), &cost);
            let seconds = effort.of_surfaces().seconds(surfaces.len(), &cost);
            work.report(Progress::Expected { stage: Stage::Referee, seconds });
            heat.check(scene, &surfaces, &effort, work)
        })
    }

    /// Walks for each of so many readings, of this cost, beside a run of about so many seconds.
    fn effort(&self, run: f64, readings: usize, cost: &WalkCost) -> Effort {
        Effort::of_seconds(self.seconds(run), readings, cost).seeded(OF_CHECKS)
    }

    /// As requested, but no more than so many seconds.
    #[must_use]
    pub fn within(self, most: f64) -> Self {
        Self { most: Some(most), ..self }
    }

    /// Seconds of the check beside a run of about so many.
    fn seconds(&self, run: f64) -> f64 {
        let wanted = self.audit.map_or_else(|| Effort::seconds_beside(run), f64::from);
        self.most.map_or(wanted, |most| wanted.min(most))
    }

    /// Walks for each row that is judged of view factors from so many surfaces; None where all of them are exact,
    /// unless asked for, and where what blocks was left out.
    pub fn of_factors(
        &self,
        factors: &ViewFactors,
        options: &view_factors::Options,
        surfaces: usize,
        scene: &Scene,
    ) -> Option<Effort> {
        let rows = surfaces.min(CheckedFactors::ROWS);
        let effort = || self.effort(factors.forecast(), rows, &WalkCost::of_view_factors(scene));
        let pays = !factors.are_exact() || self.audit.is_some();
        (options.shadows != Shadows::Off && pays).then(effort)
    }
}

/// The option by which light is not all light with its shadows, if there is one.
fn other_physics(options: &Options) -> Option<Wording> {
    let bounces = options.bounces.map(|count| set("bounces", count));
    let shots = options.shots.map(|shots| set("shots", shots.count));
    let mask = options.masks.map(|_| set("shadows", "mask"));
    let off = (options.shadows == Shadows::Off).then(|| set("shadows", "off"));
    let kernel = options.kernel.map(|_| option("kernel") + " with the rules of 1993");
    bounces.or(shots).or(mask).or(off).or(kernel)
}

impl AuditRequest {
    /// The readings to be judged of a solution of `scene`.
    pub fn judging(&self, scene: &Scene) -> CheckEffort {
        let readings = self.readings();
        CheckEffort { readings, effort: self.effort(readings, &WalkCost::of_light(scene)), seed: self.seed() }
    }

    /// Walks of this cost for each of so many readings.
    pub fn effort(&self, readings: usize, cost: &WalkCost) -> Effort {
        let seconds = self.seconds.map_or(SECONDS, f64::from);
        Effort::of_seconds(seconds, readings, cost).seeded(self.seed())
    }

    /// As many of these surfaces as are judged: one of each part of equal length.
    pub fn chosen(&self, surfaces: &[usize]) -> Vec<usize> {
        evenly(surfaces.iter().copied(), surfaces.len(), self.readings(), self.seed()).collect()
    }

    fn readings(&self) -> usize {
        self.readings.map_or(READINGS, Readings::count)
    }

    fn seed(&self) -> u64 {
        self.seed.map_or(0, u64::from)
    }
}
