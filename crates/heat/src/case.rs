//! The case of a balance: its scene, what is known of each surface, and how it is solved.

use radiosity_scene::Scene;
use radiosity_solve::{Direct, Options};
use radiosity_work::ranks::Ranks;

use super::error::HeatError;
use super::forecast::Forecast;
use super::roles::Roles;

/// The scene of a balance with the backs that heat reaches, the roles of its surfaces, and the options of its light.
#[derive(Debug)]
pub(super) struct Case {
    pub(super) scene: Scene,
    pub(super) roles: Roles,
    pub(super) options: Options,
}

impl Case {
    /// The case of a scene with its backs.
    ///
    /// # Errors
    /// Surfaces of which too little is known.
    pub(super) fn of(scene: Scene, wanted: &Options) -> Result<Self, HeatError> {
        let roles = Roles::of(&scene)?;
        let tolerance = wanted.tolerance.max(roles.rounding(&scene));
        let options = Options { direct: Direct::Projected, near_layers: true, tolerance, ..*wanted };
        Ok(Self { scene, roles, options })
    }

    /// Forecast of its memory.
    pub(super) fn forecast<'a>(&'a self, ranks: &'a Ranks) -> Forecast<'a> {
        Forecast::of(&self.scene, &self.roles, &self.options, ranks)
    }
}
