//! The heat of a surface from its irradiance.

use serde::{Deserialize, Serialize};

use crate::referee::Mean;

use super::roles::{Role, STEFAN_BOLTZMANN};

/// The heat of one surface, as means over what nothing stands on. Given numbers have the error 0; all are no
/// numbers where a walk is caught among surfaces that absorb nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HeatEstimate {
    /// Index of the surface.
    pub surface: usize,
    /// Irradiance H̄ (W m⁻²).
    pub irradiance: Mean,
    /// Level σ T⁴ (W m⁻²).
    pub level: Mean,
    /// Temperature (K) of that level; 0 where noise has put that below 0.
    pub temperature: Mean,
    /// Net flux q (W m⁻²) that leaves it.
    pub flux: Mean,
    /// Net flow q A (W) that leaves it.
    pub flow: Mean,
    /// Rays that were traced for it.
    pub rays: u64,
}

/// The irradiance of a surface by one move of the lattice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Irradiance {
    /// L₀ (W m⁻²).
    pub(super) reference: f64,
    /// The irradiance above L₀ (W m⁻²).
    pub(super) above: f64,
    /// Of a sheet its level above L₀ (W m⁻²).
    pub(super) sheet: f64,
    /// Area of what nothing stands on.
    pub(super) area: f64,
}

impl Irradiance {
    /// Level of the surface, over L₀.
    fn level_above(&self, role: &Role) -> f64 {
        match *role {
            Role::Temperature { level, .. } => level - self.reference,
            Role::Flux { flux: 0.0, .. } => self.above,
            Role::Flux { emissivity, flux } => self.above + flux / emissivity.unwrap_or(1.0),
            Role::Sheet { .. } => self.sheet,
        }
    }

    fn flux(&self, role: &Role) -> f64 {
        match *role {
            Role::Flux { flux, .. } => flux,
            Role::Temperature { emissivity, .. } | Role::Sheet { emissivity, .. } => {
                emissivity * (self.level_above(role) - self.above)
            }
        }
    }
}

/// The heat of a surface from independent irradiances.
pub(super) fn estimate(surface: usize, role: &Role, all: &[Irradiance], rays: u64) -> HeatEstimate {
    let mean = |value: &dyn Fn(&Irradiance) -> f64| Mean::of(&all.iter().map(value).collect::<Vec<_>>());
    let level = raised(mean(&|own| own.level_above(role)), all[0].reference);
    HeatEstimate {
        surface,
        irradiance: raised(mean(&|own| own.above), all[0].reference),
        temperature: temperature(&level),
        level,
        flux: mean(&|own| own.flux(role)),
        flow: mean(&|own| own.flux(role) * own.area),
        rays,
    }
}

fn raised(mean: Mean, by: f64) -> Mean {
    Mean { value: mean.value + by, ..mean }
}

/// The temperature of a level.
fn temperature(level: &Mean) -> Mean {
    let kelvin = |level: f64| (level / STEFAN_BOLTZMANN).sqrt().sqrt();
    let value = if level.value < 0.0 { 0.0 } else { kelvin(level.value) };
    let slope = 4.0 * STEFAN_BOLTZMANN * value.powi(3);
    // Near 0 K a level tells little: its whole error is taken.
    let error = if level.value > level.error { level.error / slope } else { kelvin(level.error) };
    Mean { value, error }
}
