//! Requests for a referee: how long it looks, and at how many readings.

use radiosity_audit::Effort;
use radiosity_reading::checked_factors::CheckedFactors;
use radiosity_reading::judging::{Judging, evenly, told};
use radiosity_reading::quality::ReadSettings;
use radiosity_scene::Scene;
use radiosity_solve::solved::Solved;
use radiosity_solve::view_factors::{self, ViewFactors};
use radiosity_visibility::Shadows;
use serde::Deserialize;

use super::ranges::{Number, Readings, Seconds, Seed};

/// Seconds of looking unless told otherwise. Chosen: most rooms then show errors of half a percent.
const SECONDS: f64 = 2.0;

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
    /// Seconds that about two threads take to check what is printed by path tracing; the number of rays follows
    /// from this and from counts of the scene [default: a tenth of the run, 0.1 to 5]
    #[cfg_attr(feature = "clap", arg(long, value_name = "SECONDS", allow_negative_numbers = true))]
    pub audit: Option<Number<Seconds>>,
}

impl CheckRequest {
    /// Readings that are checked. Chosen: an L2 mean of 64 is known to a tenth of itself.
    pub const READINGS: usize = READINGS;

    /// Walks for each of so many readings of a scene, beside a run of about so many seconds, which follow from counts
    /// of its work.
    pub fn effort(&self, run: f64, readings: usize, scene: &Scene) -> Effort {
        match self.audit {
            Some(seconds) => Effort::of_seconds(f64::from(seconds), readings, scene),
            None => Effort::beside(run, readings, scene),
        }
    }

    /// Walks for each row that is judged of view factors from so many surfaces; None where all of them are exact, or
    /// what blocks was left out, unless asked for.
    pub fn of_factors(
        &self,
        factors: &ViewFactors,
        options: &view_factors::Options,
        surfaces: usize,
        scene: &Scene,
    ) -> Option<Effort> {
        let pays = options.shadows != Shadows::Off && !factors.are_exact();
        let effort = || self.effort(factors.forecast(), surfaces.min(CheckedFactors::ROWS), scene);
        (pays || self.audit.is_some()).then(effort)
    }
}

impl AuditRequest {
    /// The readings to be judged of a solution that is read with `settings`.
    pub fn judging(&self, solved: &Solved, settings: &ReadSettings) -> Judging {
        let readings = self.readings();
        let effort = self.effort(readings, &solved.scene);
        Judging { readings, effort, seed: self.seed(), told: told(solved, settings) }
    }

    /// Walks for each of so many readings of a scene.
    pub fn effort(&self, readings: usize, scene: &Scene) -> Effort {
        let seconds = self.seconds.map_or(SECONDS, f64::from);
        Effort::of_seconds(seconds, readings, scene).seeded(self.seed())
    }

    /// As many of these surfaces as are judged: one of each part of equal length.
    pub fn chosen(&self, surfaces: &[usize]) -> Vec<usize> {
        let count = surfaces.len();
        evenly(surfaces.iter().copied(), count, self.readings().min(count), self.seed()).collect()
    }

    fn readings(&self) -> usize {
        self.readings.map_or(READINGS, Readings::count)
    }

    fn seed(&self) -> u64 {
        self.seed.map_or(0, u64::from)
    }
}
