//! Thermal conditions as typed.

use radiosity_scene::{
    BackCondition, Condition, Fault, Thermal,
    error::Located,
    thermal::{check_emissivity, check_temperature},
    tree::{Node, Value as NodeValue},
};
use serde_json::{Value, json};

use crate::{
    fields::{checked, real, text},
    keys::{GivenFields, ValueKind, keys},
    kinds::TRUTH,
    terms,
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
        back: Option<BackCondition> = ValueKind::new(back, back_schema),
            "Heat of the back of a surface of one side: \"adiabatic\", \"front\", or its temperature, K";
    }
}

/// `adiabatic = false` says nothing.
fn check(own: &ConditionFile, fields: &GivenFields<'_>) -> Result<(), Located> {
    let adiabatic: &[&'static str] = if own.adiabatic == Some(true) { &["adiabatic"] } else { &[] };
    fields.at_most_one(&[&["temperature", "heat_flux"], adiabatic].concat())
}

/// Words for the heat of a back.
const BACKS: [(&str, BackCondition); 2] =
    [("adiabatic", BackCondition::Adiabatic), ("front", BackCondition::Front)];

/// One of these words, or a temperature.
fn back(node: &Node) -> Result<BackCondition, Located> {
    let word = text(node).ok().map(|typed| typed.value);
    if let Some((_, condition)) = BACKS.iter().find(|(known, _)| word.as_deref() == Some(known)) {
        return Ok(*condition);
    }
    let kelvin = checked(node, check_temperature).map(BackCondition::Temperature);
    kelvin.map_err(|fault| match node.value {
        NodeValue::Text(_) | NodeValue::Formula(_) | NodeValue::Truth(_) => {
            let cause = "a back is \"adiabatic\", as the \"front\", or has a temperature";
            Located::at(&node.span, Fault::conflict(cause, "write one of both, or kelvin"))
        }
        _ => fault,
    })
}

fn back_schema() -> Value {
    let words = json!({ "enum": BACKS.map(|(word, _)| word) });
    let kelvin = terms::ranged(json!({ "minimum": 0, "maximum": 1e6 }), "Kelvin");
    json!({ "anyOf": [words, kelvin["anyOf"][0], kelvin["anyOf"][1]] })
}

impl ConditionFile {
    /// The heat of a surface, as far as it is known, or of a material of this emissivity.
    pub(crate) fn thermal(&self, emissivity: Option<f64>) -> Thermal {
        let adiabatic = self.adiabatic.filter(|is| *is).map(|_| 0.0);
        let flux = self.heat_flux.or(adiabatic).map(Condition::HeatFlux);
        let condition = self.temperature.map(Condition::Temperature).or(flux);
        Thermal { emissivity, condition, back: self.back }
    }
}
