//! Scenes whose heat no walk can tell.

use radiosity::audit::HeatReferee;
use radiosity_test_support::scenes::typed;

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
    let apart = refused(&apart);
    assert!(apart.contains("\"wall-left\"") && !apart.contains("\"floor\""), "{apart}");
}
