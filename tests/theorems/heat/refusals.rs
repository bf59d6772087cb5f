//! Scenes that have no balance of heat, or cannot be read.

use super::shared::{CUBE, at_order};

/// The message and the cure of a scene whose heat has no balance.
fn refused(text: &str) -> String {
    let error = at_order(0, text).err().unwrap_or_else(|| panic!("{text} has a balance"));
    format!("{error}: {}", error.cure().unwrap_or_default())
}

#[test]
fn what_has_no_balance_is_told_with_names_and_cure() {
    let unknown = refused(&CUBE.replace(", adiabatic = true", ""));
    assert!(unknown.contains("\"wall-left\"") && unknown.contains("adiabatic = true"), "{unknown}");
    let floats = refused(
        &CUBE.replace("temperature = 1000", "heat_flux = 5").replace("temperature = 500", "heat_flux = -5"),
    );
    assert!(floats.contains("no temperature sets the level") && floats.contains("\"floor\""), "{floats}");
    let cold = refused(&CUBE.replace("temperature = 500", "heat_flux = -100000"));
    assert!(cold.contains("\"ceiling\"") && cold.contains("draw less heat"), "{cold}");
    let coloured =
        format!("bands = [\"r\", \"g\"]\n{}", CUBE.replace("emissivity = 0.5", "reflectance = 0.5"));
    let coloured = refused(&coloured.replace("adiabatic = true", "heat_flux = 1"));
    assert!(coloured.contains("no emissivity") && coloured.contains("\"wall-left\""), "{coloured}");
}

/// The message of a scene that cannot be read.
fn unread(old: &str, new: &str) -> String {
    let error =
        radiosity::language::read(&radiosity::scene::Source::new("heat.toml", &CUBE.replace(old, new)))
            .err()
            .unwrap_or_else(|| panic!("{new} is read"));
    format!("{error}: {}", error.cure().unwrap_or_default())
}

#[test]
fn wrong_conditions_are_refused_where_they_stand() {
    let cold = unread("temperature = 500", "temperature = -20");
    assert!(cold.starts_with("heat.toml:3:") && cold.contains("273.15"), "{cold}");
    let both = unread("temperature = 500", "temperature = 500, heat_flux = 3");
    assert!(both.contains("both given") && both.contains("leave one of them out"), "{both}");
    let none = unread("emissivity = 0.5", "emissivity = 0");
    assert!(none.contains("0 < ε ≤ 1") && none.contains("adiabatic = true"), "{none}");
    let much = unread("emissivity = 0.5", "emissivity = 1.2");
    assert!(much.contains("the emissivity"), "{much}");
    assert!(unread("temperature = 500", "temperature = nan").contains("finite"));
    assert!(unread("emissivity = 0.5, ", "").contains("emissivity"));
}
