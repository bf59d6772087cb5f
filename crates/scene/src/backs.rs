//! The backs of surfaces of one side, as surfaces of their own.
//!
//! Light ends at a back; heat does not: insulation sends back what it receives, and a bare sheet has the temperature
//! of its front ([`BackCondition`]).

use radiosity_fit::sides::{back_of, front_of};
use std::collections::HashMap;
use std::sync::Arc;

use radiosity_geom::{DVec3, Flipped, Surface};

use crate::{
    Scene, SceneSurface,
    thermal::{BackCondition, Condition, Thermal},
};

impl Scene {
    /// The surfaces of one side: neither two-sided nor one of two that lie back to back, called `s` and `s:back`.
    pub fn one_sided(&self) -> Vec<usize> {
        let list = &self.surfaces;
        let named: HashMap<&str, usize> =
            list.iter().enumerate().map(|(index, surface)| (surface.name.as_str(), index)).collect();
        let has_side = |surface: &SceneSurface| {
            let front = front_of(&surface.name).and_then(|front| named.get(front));
            let back = named.get(&*back_of(&surface.name));
            front.into_iter().chain(back).any(|other| lie_together(surface, &list[*other]))
        };
        let is_alone = |index: &usize| list[*index].other_side.is_none() && !has_side(&list[*index]);
        (0..list.len()).filter(is_alone).collect()
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
            name: back_of(&self.name),
            shape: Arc::new(Flipped::new(Box::new(Arc::clone(&self.shape)))),
            other_side: Some(index),
            thermal: Thermal { condition, ..self.thermal },
            ..self.clone()
        }
    }
}

/// Whether two surfaces are sides of one sheet, to a millionth of its size.
pub fn lie_together(a: &SceneSurface, b: &SceneSurface) -> bool {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let place = |surface: &SceneSurface, [u, v]: [f64; 2]| surface.shape.jet(u, v).position;
    // The sides may be charted from different corners.
    let [a_middle, b_middle] = [a, b].map(|surface| {
        corners.iter().map(|corner| place(surface, *corner)).sum::<DVec3>() / corners.len() as f64
    });
    let [a_area, b_area] = [a, b].map(|surface| surface.shape.area());
    let near = 1e-6 * a_area.sqrt();
    a_middle.distance(b_middle) <= near && (a_area - b_area).abs() <= 1e-6 * a_area
}
