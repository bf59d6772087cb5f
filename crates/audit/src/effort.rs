//! Effort: how many walks a reading gets, from counts.

use crate::lattice::MOST;
use crate::walk_cost::WalkCost;

/// Walks of one move of the lattice, as a power of 2, by which means over surfaces are normal numbers. Measured: of
/// heat and view factors they are not with fewer.
const NORMAL: u32 = 8;

/// Walks of a second look over those of the first, as a power of 2: the standard error is halved. Chosen.
const MORE: u32 = 2;

/// Part of the time of a run that its referee takes, and its least and most (s): 0.1 s see 3 % in most rooms. Measured:
/// with 0.1 of the time, which is told within a factor of three, a picture of the Cornell box took 19 % longer.
const OF_A_RUN: f64 = 0.05;
const LEAST: f64 = 0.09;
const LONGEST: f64 = 5.0;

/// Number of walks for each reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Walks of one move of the lattice, as a power of 2.
    pub(crate) log: u32,
    /// Seed of all draws.
    pub(crate) seed: u64,
}

impl Effort {
    /// Independent moves of the lattice for each reading, whose spread tells the error of their mean. Chosen: with
    /// eight the error is itself uncertain by a quarter.
    pub const SHIFTS: usize = 8;

    /// About `walks` walks for each reading, at least 8: a power of 2.
    pub fn of_walks(walks: f64) -> Self {
        let log = (walks / Self::SHIFTS as f64).max(1.0).log2().round();
        Self { log: (log as u32).min(MOST), seed: 0 }
    }

    /// About as many walks as two threads of a common machine make in `seconds` for so many readings, within a factor
    /// of two. The number follows from counts alone.
    pub fn of_seconds(seconds: f64, readings: usize, cost: &WalkCost) -> Self {
        Self::of_walks(cost.walks(seconds) / readings.max(1) as f64)
    }

    /// Seconds that the referee of a run of about so many seconds takes, which follow from counts of its work: a
    /// twentieth of them, at least 0.09 s, 5 s at the most.
    pub fn seconds_beside(run: f64) -> f64 {
        (OF_A_RUN * run).clamp(LEAST, LONGEST)
    }

    /// About the seconds that its walks of this cost take two threads for so many readings.
    pub fn seconds(&self, readings: usize, cost: &WalkCost) -> f64 {
        readings as f64 * self.walks() as f64 / cost.walks(1.0)
    }

    /// As many readings as may be judged in so many seconds, at most `most`: fewer where light goes on for long, and
    /// none where it does so for good.
    pub fn readings(seconds: f64, most: usize, cost: &WalkCost) -> usize {
        cost.readings(seconds, Self::SHIFTS, most)
    }

    /// The effort, or the least by which means over surfaces are normal numbers.
    pub fn of_surfaces(self) -> Self {
        Self { log: self.log.max(NORMAL), ..self }
    }

    /// The effort with other draws.
    pub fn seeded(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// The effort of a second look: four times the walks, with other draws.
    pub fn again(self) -> Self {
        Self { log: (self.log + MORE).min(MOST), seed: !self.seed }
    }

    /// Walks for each reading.
    pub fn walks(&self) -> u64 {
        (Self::SHIFTS as u64) << self.log
    }
}
