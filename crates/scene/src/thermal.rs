//! Thermal conditions: what is known of the heat of a surface.
//!
//! With the radiosity J and the irradiance H (W m⁻²), the temperature T (K), the emissivity ε and the Stefan–Boltzmann
//! constant σ, a grey surface has
//!
//! ```text
//! J = ε σ T⁴ + (1 − ε) H ,     q = J − H = ε (σ T⁴ − H) .
//! ```
//!
//! Either T is known, or the net flux q that leaves the surface as radiation; the other one follows from the balance of
//! the scene (`radiosity_heat`). Reference: Modest, Radiative Heat Transfer, chapter 5.

use crate::{error::Fault, ranges::check_range};

/// What is known of the heat of a surface. Bands have no part in it: it is of all wavelengths together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Thermal {
    /// Emissivity, 0 < ε ≤ 1; none if the material states none.
    pub emissivity: Option<f64>,
    /// The temperature or the flux; none if nothing is said of either.
    pub condition: Option<Condition>,
}

/// The known one of temperature and flux.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// Temperature (K), ≥ 0.
    Temperature(f64),
    /// Heat (W m⁻²) that the surface is given and sends out as radiation; below 0 where it is cooled, 0 where it is
    /// adiabatic. Of a two-sided surface both sides send it out together, at one temperature.
    HeatFlux(f64),
}

impl Thermal {
    /// Checks the ranges.
    pub(super) fn check(&self) -> Result<(), Fault> {
        self.emissivity.map_or(Ok(()), check_emissivity)?;
        match self.condition {
            Some(Condition::Temperature(kelvin)) => check_temperature(kelvin),
            Some(Condition::HeatFlux(value)) if !value.is_finite() => Err(Fault::NotFinite { value }),
            _ => Ok(()),
        }
    }
}

/// 0 < ε ≤ 1.
pub fn check_emissivity(value: f64) -> Result<(), Fault> {
    check_range(value, value > 0.0 && value <= 1.0, "the emissivity", "0 < ε ≤ 1")
}

/// 0 ≤ T ≤ 1e6 K: its fourth power stays a number to compute with.
pub fn check_temperature(value: f64) -> Result<(), Fault> {
    check_range(value, (0.0..=1e6).contains(&value), "the temperature", "0 ≤ T ≤ 1e6 kelvin")
}
