//! Backs of surfaces of one side: adiabatic, of the temperature of the front, or of their own.

use radiosity::Work;
use radiosity::audit::Effort;
use radiosity::heat::{Heat, HeatOptions};
use radiosity_test_support::compare::assert_close;
use radiosity_test_support::scenes::typed;

use super::shared::{level, lumped_and_curved, of};

/// A plate of 2 m² and emissivity 0.8 at 900 K in a black room at 300 K, with these keys.
fn plate_in_a_room(keys: &str) -> String {
    format!(
        r#"
    materials.hot = {{ emissivity = 0.8, temperature = 900 }}
    materials.wall = {{ emissivity = 1, temperature = 300 }}
    [[surfaces]]
    name = "plate"
    material = "hot"
    {keys}
    quad = {{ vertices = [[1,1,1],[3,1,1],[3,2,1],[1,2,1]] }}
    [[surfaces]]
    name = "room"
    material = "wall"
    box = {{ origin = [0, 0, 0], size = [4, 3, 3], inward = true }}
"#
    )
}

/// Net flow (W) that the walls of the room send out.
fn of_room(heat: &Heat) -> f64 {
    heat.surfaces.iter().filter(|own| own.name.starts_with("room")).map(|own| own.flow).sum()
}

#[test]
fn an_adiabatic_back_keeps_the_heat_in_the_room() {
    let heat = lumped_and_curved(&plate_in_a_room(""));
    let flow = 2.0 * 0.8 * (level(900.0) - level(300.0));
    assert_close(of(&heat, "plate").flow, flow, 1e-9);
    assert_close(of_room(&heat), -flow, 1e-9);
    assert_eq!(of(&heat, "plate:back").flow, 0.0);
    assert!(heat.is_closed(), "lost {}", heat.lost);
    let scene = typed(&plate_in_a_room(""));
    assert_eq!(heat.usual_backs(&scene), ["plate"]);
}

#[test]
fn a_back_may_have_the_temperature_of_its_front_or_its_own() {
    for (keys, kelvin) in [("back = \"front\"", 900.0), ("back = 600", 600.0)] {
        let heat = lumped_and_curved(&plate_in_a_room(keys));
        let [front, back] = [900.0, kelvin].map(|own| 2.0 * 0.8 * (level(own) - level(300.0)));
        assert_close(of(&heat, "plate").flow, front, 1e-9);
        assert_close(of(&heat, "plate:back").flow, back, 1e-9);
        assert_close(of_room(&heat), -front - back, 1e-9);
    }
}

#[test]
fn a_sheet_of_known_flux_has_one_temperature_where_its_back_is_as_its_front() {
    let [sheet, two_sided] = ["back = \"front\"", "two_sided = true"].map(|keys| {
        let text = plate_in_a_room(&format!("heat_flux = 4000\n{keys}"));
        of(&lumped_and_curved(&text), "plate").temperature
    });
    assert_close(sheet, two_sided, 1e-12);
    // All of it leaves by the front of an insulated one.
    let heat = lumped_and_curved(&plate_in_a_room("heat_flux = 4000"));
    assert_close(level(of(&heat, "plate").temperature), level(300.0) + 4000.0 / 0.8, 1e-9);
}

#[test]
fn a_hemisphere_in_a_ball_gives_what_leaves_its_opening() {
    let text = r#"
    materials.bowl = { emissivity = 0.4, temperature = 773 }
    materials.room = { emissivity = 1, temperature = 303 }
    [[surfaces]]
    name = "bowl"
    material = "bowl"
    flip = true
    sphere = { center = [0, 0, 0], radius = 0.5, z = [0, 0.5] }
    [[surfaces]]
    name = "room"
    material = "room"
    flip = true
    sphere = { center = [0, 0, 0], radius = 2 }
"#;
    let heat = lumped_and_curved(text);
    // The irradiance is even within a sphere: two nodes, the opening between them (Modest, chapter 5).
    let [bowl, opening] = [2.0, 1.0].map(|part| part * std::f64::consts::PI * 0.25);
    let flow = (level(773.0) - level(303.0)) / (0.6 / (0.4 * bowl) + 1.0 / opening);
    assert_close(of(&heat, "bowl").flow, flow, 1e-3);
    assert_close(of(&heat, "room").flow, -flow, 1e-3);
    assert!(heat.is_closed(), "lost {}", heat.lost);
}

#[test]
fn backs_that_no_heat_reaches_are_left_out() {
    let body = r#"
    materials.hot = { emissivity = 0.8, temperature = 900 }
    materials.wall = { emissivity = 1, temperature = 300 }
    [[surfaces]]
    name = "block"
    material = "hot"
    box = { origin = [1, 1, 0.5], size = [1, 1, 1] }
    [[surfaces]]
    name = "room"
    material = "wall"
    box = { origin = [0, 0, 0], size = [4, 3, 3], inward = true }
"#;
    let heat = lumped_and_curved(body);
    assert!(heat.surfaces.iter().all(|own| !own.name.ends_with(":back")));
}

#[test]
fn walks_find_the_heat_of_backs() {
    for keys in ["", "back = \"front\"", "back = 600", "heat_flux = 4000\nback = \"front\""] {
        let scene = typed(&plate_in_a_room(keys));
        let mut heat = Heat::of(&scene, &HeatOptions::default(), &Work::alone()).unwrap();
        let surfaces = heat.to_check(&scene, 8);
        heat.check(&scene, &surfaces, &Effort::of_walks(4096.0), &Work::alone()).unwrap();
        let checked = heat.checked.as_ref().unwrap();
        assert!(!checked.finds_more(), "{keys}: {checked}");
    }
}
