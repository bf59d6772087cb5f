//! Thermal conditions as typed.

use radiosity_scene::{
    Condition, Fault,
    error::Located,
    thermal::{check_emissivity, check_temperature},
    tree::Node,
};

use crate::fields::{Fields, Reader, number, truth};

/// The keys of which at most one is given.
pub(crate) const CONDITION_KEYS: [&str; 3] = ["temperature", "heat_flux", "adiabatic"];

/// The temperature or the flux of a surface, or of a material's surfaces.
pub(crate) fn read_condition(fields: &Fields<'_>) -> Result<Option<Condition>, Located> {
    let readers: [Reader<Option<Condition>>; 3] = [temperature, heat_flux, adiabatic];
    let mut found: Option<(&'static str, Condition)> = None;
    for (key, read) in CONDITION_KEYS.into_iter().zip(readers) {
        let Some(node) = fields.get(key) else { continue };
        let Some(condition) = read(node)? else { continue };
        if let Some((first, _)) = found {
            return Err(Located::at(&node.span, Fault::exclusive(first, key)));
        }
        found = Some((key, condition));
    }
    Ok(found.map(|(_, condition)| condition))
}

/// The emissivity of a material.
pub(crate) fn emissivity(node: &Node) -> Result<f64, Located> {
    let value = number(node)?.value;
    check_emissivity(value).map_err(|fault| Located::at(&node.span, fault))?;
    Ok(value)
}

fn temperature(node: &Node) -> Result<Option<Condition>, Located> {
    let value = number(node)?.value;
    check_temperature(value).map_err(|fault| Located::at(&node.span, fault))?;
    Ok(Some(Condition::Temperature(value)))
}

fn heat_flux(node: &Node) -> Result<Option<Condition>, Located> {
    Ok(Some(Condition::HeatFlux(number(node)?.value)))
}

/// `adiabatic = false` says nothing.
fn adiabatic(node: &Node) -> Result<Option<Condition>, Located> {
    Ok(truth(node)?.then_some(Condition::HeatFlux(0.0)))
}
