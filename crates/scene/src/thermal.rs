//! Thermal conditions: emissivities, and temperatures or net fluxes of surfaces.
//!
//! With the radiosity J and the irradiance H (W m⁻²), the temperature T (K), the emissivity ε and the
//! Stefan–Boltzmann constant σ, a grey surface has
//!
//! ```text
//! J = ε σ T⁴ + (1 − ε) H ,     q = J − H = ε (σ T⁴ − H) .
//! ```
//!
//! Either T is known, or the net flux q that leaves the surface as radiation; the other one follows from the
//! balance of the scene (`radiosity_heat`). Reference: Modest, Radiative Heat Transfer, chapter 5.

use crate::{fault::Fault, ranges::check_range_or};

/// Emissivity and condition of a surface, of all wavelengths together: bands have no part in them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Thermal {
    /// Emissivity, 0 < ε ≤ 1; none if the material states none.
    pub emissivity: Option<f64>,
    /// The temperature or the net flux; none if neither is given.
    pub condition: Option<Condition>,
    /// The condition of the back of a surface of one side; none if it is not given, which means
    /// [`BackCondition::Adiabatic`].
    pub back: Option<BackCondition>,
}

/// The condition of the back of a surface of one side, as far as the surfaces of a scene see it. With a temperature
/// it has the emissivity of the front.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum BackCondition {
    /// It sends out as much as it receives, as insulation does.
    #[default]
    Adiabatic,
    /// It has the temperature of the front, be that known or not.
    Front,
    /// Its own temperature (K), ≥ 0.
    Temperature(f64),
}

/// The known quantity of a surface: its temperature or its net flux.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// Temperature (K), ≥ 0.
    Temperature(f64),
    /// Heat (W m⁻²) that the surface is given and sends out as radiation; below 0 where it is cooled, 0 where
    /// it is adiabatic. Of a two-sided surface both sides send it out together, at one temperature.
    HeatFlux(f64),
}

impl Thermal {
    /// Checks the ranges of emissivity, temperature and flux.
    pub(super) fn check(&self) -> Result<(), Fault> {
        self.emissivity.map_or(Ok(()), check_emissivity)?;
        if let Some(BackCondition::Temperature(kelvin)) = self.back {
            check_temperature(kelvin)?;
        }
        match self.condition {
            Some(Condition::Temperature(kelvin)) => check_temperature(kelvin),
            Some(Condition::HeatFlux(value)) if !value.is_finite() => Err(Fault::not_finite(value)),
            _ => Ok(()),
        }
    }
}

/// Checks that 0 < ε ≤ 1.
pub fn check_emissivity(value: f64) -> Result<(), Fault> {
    let cure = "choose a value in that range; a surface that neither absorbs nor emits has adiabatic = true";
    check_range_or(value, value > 0.0 && value <= 1.0, "the emissivity", "0 < ε ≤ 1", cure)
}

/// Checks that 0 ≤ T ≤ 1e6 K: the fourth power stays a number to compute with.
pub fn check_temperature(value: f64) -> Result<(), Fault> {
    let cure = "write it in kelvin, which are degrees Celsius + 273.15: 20 °C is temperature = 293.15";
    check_range_or(value, (0.0..=1e6).contains(&value), "the temperature", "0 ≤ T ≤ 1e6 kelvin", cure)
}
