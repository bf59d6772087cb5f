//! Memory that a balance of heat will need, before anything is computed.
//!
//! To the memory of a solution come, for the conductances of n surfaces, the light of each as a group and
//!
//! ```text
//! 2 · 8 n²   bytes of C_ij, as found and symmetric.
//! ```

use radiosity_scene::Scene;
use radiosity_solve::{Model, Options};
use radiosity_work::ranks::Ranks;

use super::coats::all_emit;
use super::conductances::each_alone;
use super::cut::Cut;
use super::error::HeatError;
use super::roles::Roles;

/// Bytes of C_ij for each pair of surfaces.
const PAIR: u64 = 16;

/// Forecast of the memory of a balance.
pub(super) struct Forecast<'a> {
    scene: &'a Scene,
    roles: &'a Roles,
    options: &'a Options,
    ranks: &'a Ranks,
}

impl<'a> Forecast<'a> {
    /// Forecast for the balance of `scene` on each of these ranks.
    pub(super) fn of(scene: &'a Scene, roles: &'a Roles, options: &'a Options, ranks: &'a Ranks) -> Self {
        Self { scene, roles, options, ranks }
    }

    /// Refuses conductances that need more memory than allowed.
    pub(super) fn require_conductances(&self) -> Result<(), HeatError> {
        let Some(allowed) = self.options.memory else { return Ok(()) };
        let lit = each_alone(self.scene, self.roles)?;
        let surfaces = self.scene.surfaces.len();
        let needed = Model::peak_memory(&lit, self.options, self.ranks) + PAIR * (surfaces as u64).pow(2);
        if needed <= allowed { Ok(()) } else { Err(HeatError::Conductances { surfaces, needed, allowed }) }
    }

    /// Bytes of the transfers between the elements of the scene, at the most.
    pub(super) fn of_first(&self) -> u64 {
        Model::peak_memory(&all_emit(self.scene, self.roles), self.options, self.ranks)
    }

    /// Whether there is memory for the balance of the scene on elements that are `cut` once more, beside so many bytes.
    pub(super) fn fits(&self, cut: &Cut, beside: u64) -> bool {
        let options = Options { order: cut.order, ..*self.options };
        let lit = || all_emit(self.scene, self.roles);
        let needed = || beside + Model::peak_memory_on(&cut.mesh, &lit(), &options, self.ranks);
        self.options.memory.is_none_or(|allowed| needed() <= allowed)
    }
}
