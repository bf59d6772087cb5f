//! The balance of power of a solution.

use std::ops::{Add, Mul};

use serde::{Deserialize, Serialize};

/// Powers, summed over bands, in the unit of exitance times scene length².
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Powers {
    /// Power that surfaces and luminaires emit.
    pub emitted: f64,
    /// Power that surfaces absorb.
    pub absorbed: f64,
    /// Power that leaves the scene.
    pub lost: f64,
}

impl Add for Powers {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            emitted: self.emitted + other.emitted,
            absorbed: self.absorbed + other.absorbed,
            lost: self.lost + other.lost,
        }
    }
}

impl Mul<Powers> for f64 {
    type Output = Powers;

    fn mul(self, powers: Powers) -> Powers {
        Powers { emitted: self * powers.emitted, absorbed: self * powers.absorbed, lost: self * powers.lost }
    }
}
