//! The backs of surfaces of one side, as surfaces of their own.
//!
//! Light ends at a back; heat does not: insulation sends back what it receives, and a bare sheet has the temperature
//! of its front ([`BackCondition`]).

use std::collections::HashSet;
use std::sync::Arc;

use radiosity_geom::Flipped;

use crate::{
    Scene, SceneSurface,
    thermal::{BackCondition, Condition, Thermal},
};

/// Ending of the names of backs.
const BACK: &str = ":back";

impl Scene {
    /// The surfaces of one side: neither two-sided nor one of two that lie back to back, called `s` and `s:back`.
    pub fn one_sided(&self) -> Vec<usize> {
        let named: HashSet<&str> = self.surfaces.iter().map(|surface| surface.name.as_str()).collect();
        let has_side = |name: &str| {
            let front = name.strip_suffix(BACK);
            front.is_some_and(|front| named.contains(front)) || named.contains(&*format!("{name}{BACK}"))
        };
        let all = self.surfaces.iter().enumerate();
        let alone = all.filter(|(_, surface)| surface.other_side.is_none() && !has_side(&surface.name));
        alone.map(|(index, _)| index).collect()
    }

    /// The scene with the backs of these [surfaces of one side](Self::one_sided) behind all others, in the order of
    /// `fronts`, called `front:back` each, of the emissivity of the front. Each is the other side of its front.
    pub fn with_backs(&self, fronts: &[usize]) -> Self {
        let mut scene = self.clone();
        for front in fronts {
            let index = scene.surfaces.len();
            let own = &mut scene.surfaces[*front];
            own.thermal.back = Some(own.back_condition());
            let back = own.back(*front);
            own.other_side = Some(index);
            scene.surfaces.push(back);
        }
        scene
    }
}

impl SceneSurface {
    /// The condition of its back, where it is of one side.
    pub fn back_condition(&self) -> BackCondition {
        self.thermal.back.unwrap_or_default()
    }

    /// Whether it is a side of a sheet whose other side has a condition of its own.
    pub fn is_insulated(&self) -> bool {
        self.other_side.is_some() && self.thermal.back.is_some_and(|back| back != BackCondition::Front)
    }

    /// The back of this surface of one side, which has that `index` in the scene.
    fn back(&self, index: usize) -> Self {
        let condition = match self.back_condition() {
            BackCondition::Adiabatic => Some(Condition::HeatFlux(0.0)),
            BackCondition::Front => self.thermal.condition,
            BackCondition::Temperature(kelvin) => Some(Condition::Temperature(kelvin)),
        };
        Self {
            name: format!("{}{BACK}", self.name),
            shape: Arc::new(Flipped::new(Box::new(Arc::clone(&self.shape)))),
            other_side: Some(index),
            thermal: Thermal { condition, ..self.thermal },
            ..self.clone()
        }
    }
}
