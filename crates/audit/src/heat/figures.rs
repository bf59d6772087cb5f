//! The heat of a surface from its irradiance.

use serde::{Deserialize, Serialize};

use crate::referee::Mean;

use super::roles::{Role, STEFAN_BOLTZMANN};

/// The heat of one surface, as means over what nothing stands on. Given numbers have the error 0; all are no
/// numbers where a walk is caught among surfaces that absorb nothing, or none of them ends.
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

impl HeatEstimate {
    /// No numbers.
    pub(super) fn of_nothing(surface: usize) -> Self {
        let none = Mean { value: f64::NAN, error: f64::NAN };
        Self { surface, irradiance: none, level: none, temperature: none, flux: none, flow: none, rays: 0 }
    }
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
    /// Part of the area that nothing stands on.
    pub(super) bare: f64,
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

fn mean(all: &[Irradiance], value: impl Fn(&Irradiance) -> f64) -> Mean {
    Mean::of(&all.iter().map(value).collect::<Vec<_>>())
}

/// The flow out of a surface of this area from independent irradiances. Where no more than this part is
/// covered, that is the margin of what touches it: nothing is, and the flow is as uncertain as that.
pub(super) fn flow(role: &Role, all: &[Irradiance], area: f64, margin: f64) -> Mean {
    let covered = mean(all, |own| 1.0 - own.bare).value;
    if covered > margin {
        return mean(all, |own| own.flux(role) * own.bare * area);
    }
    let Mean { value, error } = mean(all, |own| own.flux(role) * area);
    Mean { value, error: error.hypot(covered * value) }
}

/// The heat of a surface from independent irradiances, without flow and rays.
pub(super) fn estimate(surface: usize, role: &Role, all: &[Irradiance]) -> HeatEstimate {
    let level = raised(mean(all, |own| own.level_above(role)), all[0].reference);
    HeatEstimate {
        surface,
        irradiance: raised(mean(all, |own| own.above), all[0].reference),
        temperature: temperature(&level),
        level,
        flux: mean(all, |own| own.flux(role)),
        flow: Mean::default(),
        rays: 0,
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
