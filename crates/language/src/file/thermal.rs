//! Thermal conditions as typed.

use radiosity_scene::{
    Condition,
    error::Located,
    thermal::{check_emissivity, check_temperature},
};
use serde_json::json;

use crate::{
    fields::{checked, real},
    keys::{GivenFields, ValueKind, keys},
    kinds::TRUTH,
};

/// The emissivity of a material.
pub(crate) const EMISSIVITY: ValueKind<f64> = ValueKind::number(
    |node| checked(node, check_emissivity),
    || json!({ "exclusiveMinimum": 0, "maximum": 1 }),
);

keys! {
    /// The temperature or the flux of a surface, or of a material's surfaces: one of them, or none.
    ConditionFile("What is known of its heat"; check) {
        temperature: Option<f64> =
            ValueKind::number(|node| checked(node, check_temperature), || json!({ "minimum": 0, "maximum": 1e6 })),
            "Temperature, K";
        heat_flux: Option<f64> =
            ValueKind::number(real, || json!({ "minimum": -1e30, "maximum": 1e30 })),
            "Heat that it is given and sends out as radiation, W/m²";
        adiabatic: Option<bool> = TRUTH, "It sends out as much as it receives";
    }
}

/// `adiabatic = false` says nothing.
fn check(own: &ConditionFile, fields: &GivenFields<'_>) -> Result<(), Located> {
    let adiabatic: &[&'static str] = if own.adiabatic == Some(true) { &["adiabatic"] } else { &[] };
    fields.at_most_one(&[&["temperature", "heat_flux"], adiabatic].concat())
}

impl ConditionFile {
    pub(crate) fn condition(&self) -> Option<Condition> {
        let adiabatic = self.adiabatic.filter(|is| *is).map(|_| 0.0);
        let flux = self.heat_flux.or(adiabatic).map(Condition::HeatFlux);
        self.temperature.map(Condition::Temperature).or(flux)
    }
}
