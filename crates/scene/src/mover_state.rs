//! States of movers: where one is, and how brightly it shines.

use crate::{fault::Fault, material::check_count, pose::Pose, ranges::check_factor};

/// The pose of a mover, and factors on what its surfaces and luminaires emit.
#[derive(Clone, Debug, PartialEq)]
pub struct MoverState {
    /// Its pose, in the coordinates that the scene is computed in ([`Pose::about`]).
    pub pose: Pose,
    /// Factor ≥ 0 of each band on what it emits at rest; empty where that stays.
    pub factors: Vec<f64>,
}

impl MoverState {
    /// A mover at rest, which emits what is stated.
    pub const REST: Self = Self { pose: Pose::REST, factors: Vec::new() };

    /// Whether it emits something else than at rest.
    pub(crate) fn is_dimmed(&self) -> bool {
        self.factors.iter().any(|factor| *factor != 1.0)
    }

    /// Checks that there are no factors, or one in range of each of `bands` bands.
    pub(crate) fn check(&self, bands: usize) -> Result<(), Fault> {
        if !self.factors.is_empty() {
            check_count("the list of factors", &self.factors, bands)?;
        }
        self.factors.iter().try_for_each(|factor| check_factor(*factor))
    }
}
