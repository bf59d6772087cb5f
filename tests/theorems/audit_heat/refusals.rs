//! Scenes whose heat no walk can tell.

use radiosity::audit::HeatReferee;
use radiosity_test_support::scenes::typed;

use super::scored::{heat, level, of};

const BOX: &str = r#"
    materials.hot = { emissivity = 1, temperature = 1000 }
    materials.brick = { emissivity = 0.5, adiabatic = true }
    [[surfaces]]
    name = "floor"
    material = "hot"
    quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
    [[surfaces]]
    name = "wall"
    material = "brick"
    box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true, open = ["bottom"] }
"#;

fn refused(text: &str) -> String {
    let fault = HeatReferee::of(&typed(text)).err().unwrap_or_else(|| panic!("{text} is taken"));
    format!("{fault}: {}", fault.cure())
}

#[test]
fn what_walks_cannot_tell_is_refused_with_names_and_cure() {
    assert!(HeatReferee::of(&typed(BOX)).is_ok());
    let unknown = refused(&BOX.replace(", adiabatic = true", ""));
    assert!(unknown.contains("\"wall-left\"") && unknown.contains("adiabatic = true"), "{unknown}");
    let floats = refused(&BOX.replace("temperature = 1000", "heat_flux = 5"));
    assert!(floats.contains("\"floor\"") && floats.contains("give one of them a temperature"), "{floats}");
    let coloured =
        format!("bands = [\"r\", \"g\"]\n{}", BOX.replace("emissivity = 0.5", "reflectance = 0.5"));
    let coloured = refused(&coloured.replace("adiabatic = true", "heat_flux = 1"));
    assert!(coloured.contains("no emissivity") && coloured.contains("\"wall-left\""), "{coloured}");
    // A part by itself in a scene that has a temperature.
    let apart = BOX.replace("origin = [0, 0, 0]", "origin = [5, 0, 0]").replace(", open = [\"bottom\"]", "");
    let apart = refused(&apart.replace("adiabatic = true", "heat_flux = 1"));
    assert!(apart.contains("\"wall-left\"") && !apart.contains("\"floor\""), "{apart}");
}

#[test]
fn walks_that_are_caught_tell_no_number() {
    // Under a hood that is adiabatic inside nothing sets the level, but the floor goes on outside.
    let text = r#"
        materials.hot = { emissivity = 1, temperature = 1000 }
        materials.brick = { emissivity = 0.5, adiabatic = true }
        [[surfaces]]
        name = "floor"
        material = "brick"
        quad = { vertices = [[-3,-3,0],[4,-3,0],[4,4,0],[-3,4,0]] }
        [[surfaces]]
        name = "hood"
        material = "brick"
        box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true, open = ["bottom"] }
        [[surfaces]]
        name = "plate"
        material = "hot"
        quad = { vertices = [[0,0,2],[0,1,2],[1,1,2],[1,0,2]] }
    "#;
    let found = heat(text, 64.0, 0);
    assert!(of(&found, "hood-top").level.value.is_nan(), "{:?}", of(&found, "hood-top"));
    let plate = of(&found, "plate").flux;
    assert!(plate.value > 0.5 * level(1000.0) && plate.value <= level(1000.0), "{plate:?}");
}
