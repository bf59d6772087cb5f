//! Requests for a referee: how long it looks, and at how many readings.

use radiosity_audit::Effort;
use radiosity_reading::judging::{Judging, told};
use radiosity_reading::quality::ReadSettings;
use radiosity_solve::solved::Solved;
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

    /// About the number of readings that are judged [default: 64]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N", allow_negative_numbers = true))]
    pub readings: Option<Readings>,

    /// Chooses other places and other rays [default: 0]
    #[cfg_attr(feature = "clap", arg(long, value_name = "K", allow_negative_numbers = true))]
    pub seed: Option<Seed>,
}

impl AuditRequest {
    /// The readings to be judged of a solution that is read with `settings`.
    pub fn judging(&self, solved: &Solved, settings: &ReadSettings) -> Judging {
        let readings = self.readings.map_or(READINGS, Readings::count);
        let seconds = self.seconds.map_or(SECONDS, f64::from);
        let seed = self.seed.map_or(0, u64::from);
        let effort = Effort::of_seconds(seconds, readings, &solved.scene).seeded(seed);
        Judging { readings, effort, seed, told: told(solved, settings) }
    }
}
