//! The role of each surface in the balance of heat.

use radiosity_fit::sides::front_of;
use std::collections::HashMap;

use radiosity_scene::backs::lie_together;
use radiosity_scene::{Condition, Scene, SceneSurface};

use super::black_body::level;
use super::error::HeatError;

/// Roundings that are left in a residual. Measured: one in a cube of emissivities of 1e-9.
const ROUNDINGS: f64 = 2.0;

/// Known quantity of a surface: its temperature or its flux.
#[derive(Clone, Copy, Debug)]
pub(super) enum Role {
    /// Its temperature (K).
    Temperature { emissivity: f64, kelvin: f64 },
    /// The flux (W m⁻²) that it sends out; without an emissivity its temperature is only known where that
    /// flux is 0.
    Flux { emissivity: Option<f64>, flux: f64 },
    /// The flow of both sides of a sheet together; its index among the shields.
    Shield { emissivity: f64, shield: usize },
    /// It neither gains nor loses heat, and nothing sets its level: it exchanges with others of its kind alone.
    Idle { emissivity: Option<f64> },
}

impl Role {
    /// The emissivity; None where none was given and none is needed.
    pub(super) fn emissivity(&self) -> Option<f64> {
        match *self {
            Self::Temperature { emissivity, .. } | Self::Shield { emissivity, .. } => Some(emissivity),
            Self::Flux { emissivity, .. } | Self::Idle { emissivity } => emissivity,
        }
    }
}

/// A sheet whose two sides have one unknown temperature.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shield {
    /// Indices of front and back.
    pub(super) sides: [usize; 2],
    /// Flux (W m⁻²) per area of the sheet that both sides send out together.
    pub(super) flux: f64,
}

/// The roles of all surfaces.
#[derive(Debug)]
pub(super) struct Roles {
    /// One for each surface.
    pub(super) list: Vec<Role>,
    pub(super) shields: Vec<Shield>,
}

impl Roles {
    /// The roles of the surfaces of `scene`.
    ///
    /// # Errors
    /// Surfaces of which too little is known.
    pub(super) fn of(scene: &Scene) -> Result<Self, HeatError> {
        match named(scene, |_, surface| surface.material.transmits()) {
            surfaces if surfaces.is_empty() => {}
            surfaces => return Err(HeatError::Transmits { surfaces }),
        }
        let unknown = |surface: &SceneSurface| surface.thermal.condition.is_none();
        match named(scene, |_, surface| unknown(surface)) {
            surfaces if surfaces.is_empty() => {}
            surfaces => return Err(HeatError::NoCondition { surfaces }),
        }
        let shields = shields(scene);
        let of_surface: HashMap<usize, usize> =
            shields.iter().enumerate().flat_map(|(k, shield)| shield.sides.map(|side| (side, k))).collect();
        // The temperature of what neither gains nor loses heat does not depend on its emissivity.
        let needs = |index: usize, surface: &SceneSurface| {
            let is_adiabatic = surface.thermal.condition == Some(Condition::HeatFlux(0.0));
            emissivity(scene, surface).is_none() && (!is_adiabatic || of_surface.contains_key(&index))
        };
        match named(scene, needs) {
            surfaces if surfaces.is_empty() => {}
            surfaces => return Err(HeatError::NoEmissivity { surfaces }),
        }
        let role = |(index, surface): (usize, &SceneSurface)| {
            let emissivity = emissivity(scene, surface);
            let known = || emissivity.expect("it was looked for above");
            match (surface.thermal.condition.expect("it was looked for above"), of_surface.get(&index)) {
                (Condition::Temperature(kelvin), _) => Role::Temperature { emissivity: known(), kelvin },
                (Condition::HeatFlux(_), Some(shield)) => {
                    Role::Shield { emissivity: known(), shield: *shield }
                }
                (Condition::HeatFlux(flux), None) => Role::Flux { emissivity, flux },
            }
        };
        Ok(Self { list: scene.surfaces.iter().enumerate().map(role).collect(), shields })
    }

    /// The relative residual that rounding leaves of the light of `scene`: where hardly anything is absorbed, far more
    /// is on its way than is emitted,
    ///
    /// ```text
    /// u ‖J‖ / ‖e‖ ,     ‖J‖ ≤ L (Σ A)^½ ,     L the largest known level ,     L = 1 and e = ε of each shield .
    /// ```
    pub(super) fn rounding(&self, scene: &Scene) -> f64 {
        let areas: Vec<f64> = scene.surfaces.iter().map(|surface| surface.shape.area()).collect();
        let all = areas.iter().sum::<f64>().sqrt();
        let (mut largest, mut emitted, mut rounding) = (0.0, 0.0, 0.0);
        for (role, area) in self.list.iter().zip(&areas) {
            match *role {
                Role::Temperature { emissivity, kelvin } => {
                    largest = f64::max(largest, level(kelvin));
                    emitted += area * (emissivity * level(kelvin)).powi(2);
                }
                Role::Flux { flux, .. } => emitted += area * flux * flux,
                Role::Shield { emissivity, .. } => {
                    rounding = f64::max(rounding, all / (emissivity * area.sqrt()));
                }
                Role::Idle { .. } => {}
            }
        }
        if emitted > 0.0 {
            rounding = rounding.max(largest * all / emitted.sqrt());
        }
        ROUNDINGS * f64::EPSILON * rounding
    }

    /// Whether a surface neither gains nor loses heat by itself; of a sheet, both sides together.
    pub(super) fn is_adiabatic(&self, surface: usize) -> bool {
        match self.list[surface] {
            Role::Temperature { .. } => false,
            Role::Flux { flux, .. } => flux == 0.0,
            Role::Shield { shield, .. } => self.shields[shield].flux == 0.0,
            Role::Idle { .. } => true,
        }
    }

    /// Makes surfaces idle, both sides of sheets.
    pub(super) fn idle(&mut self, is_idle: impl Fn(usize) -> bool) {
        let list = self.list.iter_mut().enumerate().filter(|(surface, _)| is_idle(*surface));
        list.for_each(|(_, role)| *role = Role::Idle { emissivity: role.emissivity() });
        self.shields.retain(|shield| !is_idle(shield.sides[0]));
        for (k, shield) in self.shields.iter().enumerate() {
            for side in shield.sides {
                if let Role::Shield { shield, .. } = &mut self.list[side] {
                    *shield = k;
                }
            }
        }
    }
}

/// Names of the surfaces of which `holds` is true, as messages call them.
pub(super) fn named(scene: &Scene, holds: impl Fn(usize, &SceneSurface) -> bool) -> Vec<String> {
    let all = scene.surfaces.iter().enumerate().filter(|(index, surface)| holds(*index, surface));
    all.map(|(index, _)| called(scene, index)).collect()
}

/// Name of a surface in messages: the one that was typed.
pub(super) fn called(scene: &Scene, index: usize) -> String {
    match scene.surfaces[index].other_side.filter(|front| *front < index) {
        Some(front) => format!("the back of {:?}", scene.shown_name(front)),
        None => format!("{:?}", scene.shown_name(index)),
    }
}

/// The emissivity that is given, else 1 − ρ in scenes of a single band where ρ is the same all over the
/// surface.
fn emissivity(scene: &Scene, surface: &SceneSurface) -> Option<f64> {
    let is_grey = scene.bands.len() == 1 && surface.material.reflectance_pattern.is_none();
    let grey = || is_grey.then(|| 1.0 - surface.material.reflectance[0]);
    surface.thermal.emissivity.or_else(grey)
}

/// The two-sided surfaces of known flux: two fronts back to back, of one condition, which two materials may
/// have.
fn shields(scene: &Scene) -> Vec<Shield> {
    let fronts: HashMap<&str, usize> =
        scene.surfaces.iter().enumerate().map(|(index, own)| (own.name.as_str(), index)).collect();
    let shield = |(back, surface): (usize, &SceneSurface)| {
        let Some(Condition::HeatFlux(flux)) = surface.thermal.condition else { return None };
        let front = *fronts.get(front_of(&surface.name)?)?;
        // A surface may be called so without being a back. Sides of other conditions are insulated from each
        // other.
        let other = &scene.surfaces[front];
        let is_one = !surface.is_insulated() && other.thermal.condition == surface.thermal.condition;
        let is_sheet = is_one && lie_together(other, surface);
        is_sheet.then_some(Shield { sides: [front, back], flux })
    };
    scene.surfaces.iter().enumerate().filter_map(shield).collect()
}
