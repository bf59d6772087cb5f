//! Effort: how many walks a reading gets, from counts.

use crate::lattice::MOST;

/// Walks a second of two threads of a common machine in a scene of few surfaces. Measured: see `docs/theory/error.md`.
const WALKS_A_SECOND: f64 = 8e5;

/// Independent moves of the lattice for each reading, whose spread tells the error of their mean. Chosen: with
/// eight the error is itself uncertain by a quarter.
const SHIFTS: usize = 8;

/// Walks of a second look over those of the first, as a power of 2: the standard error is halved. Chosen.
const MORE: u32 = 2;

/// Number of walks for each reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Walks of one move of the lattice, as a power of 2.
    pub(crate) log: u32,
    /// Seed of all draws.
    pub(crate) seed: u64,
}

impl Effort {
    /// Independent moves of the lattice for each reading.
    pub const SHIFTS: usize = SHIFTS;

    /// About `walks` walks for each reading, at least 8: a power of 2.
    pub fn of_walks(walks: f64) -> Self {
        let log = (walks / SHIFTS as f64).max(1.0).log2().round();
        Self { log: (log as u32).min(MOST), seed: 0 }
    }

    /// About as many walks as two threads of a common machine make in `seconds` for so many readings of a scene
    /// of so many surfaces. The number follows from these counts alone.
    pub fn of_seconds(seconds: f64, readings: usize, surfaces: usize) -> Self {
        // A ray visits as many more nodes as the tree is deep.
        let slower = 1.0 + 0.25 * (surfaces.max(16) as f64 / 16.0).log2();
        Self::of_walks(seconds * WALKS_A_SECOND / slower / readings.max(1) as f64)
    }

    /// The effort with other draws.
    pub fn seeded(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// The effort of a second look: four times the walks, with other draws.
    pub(crate) fn again(self) -> Self {
        Self { log: (self.log + MORE).min(MOST), seed: !self.seed }
    }

    /// Walks for each reading.
    pub fn walks(&self) -> u64 {
        (SHIFTS as u64) << self.log
    }
}
