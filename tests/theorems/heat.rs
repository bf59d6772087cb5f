//! Radiant heat against closed forms of grey enclosures (Modest, Radiative Heat Transfer, chapter 5), at order 0 where the
//! forms are those of networks; and what a balance of heat cannot be made of.

use radiosity::Scene;
use radiosity::heat::{Heat, HeatError, HeatOptions, STEFAN_BOLTZMANN, SurfaceHeat};
use radiosity::solve::{Options, Transport};

fn scene(text: &str) -> Scene {
    Scene::from_toml(text, "heat.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn at_order(order: usize, text: &str) -> Result<Heat, HeatError> {
    to_accuracy(1e-11, order, text)
}

fn to_accuracy(eps: f64, order: usize, text: &str) -> Result<Heat, HeatError> {
    let options = Options {
        order,
        subdivide: Some(1),
        eps,
        shadow_eps: eps,
        transport: Transport::Exact,
        tolerance: 1e-13,
        ..Options::default()
    };
    Heat::of(&scene(text), &HeatOptions { options, conductances: true }, &|_| {})
}

fn lumped(text: &str) -> Heat {
    at_order(0, text).unwrap_or_else(|error| panic!("{error}"))
}

/// Flat surfaces take their closed forms at any `eps`, curved ones take longer for a smaller one.
fn lumped_and_curved(text: &str) -> Heat {
    to_accuracy(1e-3, 0, text).unwrap_or_else(|error| panic!("{error}"))
}

fn of<'a>(heat: &'a Heat, name: &str) -> &'a SurfaceHeat {
    heat.surfaces.iter().find(|own| own.name == name).unwrap()
}

fn level(kelvin: f64) -> f64 {
    STEFAN_BOLTZMANN * kelvin.powi(4)
}

#[track_caller]
fn close(found: f64, expected: f64, accuracy: f64) {
    assert!((found - expected).abs() <= accuracy * expected.abs(), "{found} instead of {expected}");
}

/// The inside of a sphere of radius 2 at 300 K around a sphere of radius 1.
fn spheres(inner: &str, between: &str) -> String {
    format!(
        r#"
        [materials.hot]
        emissivity = 0.8
        {inner}
        [materials.cold]
        emissivity = 0.6
        temperature = 300
        [materials.foil]
        emissivity = 0.05
        adiabatic = true
        [[surfaces]]
        name = "inner"
        material = "hot"
        sphere = {{ center = [0, 0, 0], radius = 1 }}
        [[surfaces]]
        name = "outer"
        material = "cold"
        flip = true
        sphere = {{ center = [0, 0, 0], radius = 2 }}
        {between}
        "#
    )
}

const FOIL: &str = r#"
        [[surfaces]]
        name = "foil"
        material = "foil"
        two_sided = true
        sphere = { center = [0, 0, 0], radius = 1.5 }
"#;

/// Area of a sphere.
fn sphere(radius: f64) -> f64 {
    4.0 * std::f64::consts::PI * radius * radius
}

/// (1 − ε) / (ε A).
fn surface_resistance(emissivity: f64, area: f64) -> f64 {
    (1.0 - emissivity) / (emissivity * area)
}

/// Between the surfaces of concentric spheres.
fn of_spheres() -> f64 {
    surface_resistance(0.8, sphere(1.0)) + 1.0 / sphere(1.0) + surface_resistance(0.6, sphere(2.0))
}

#[test]
fn concentric_spheres_exchange_what_two_resistances_let_through() {
    let heat = lumped_and_curved(&spheres("temperature = 500", ""));
    let flow = (level(500.0) - level(300.0)) / of_spheres();
    close(of(&heat, "inner").flow, flow, 1e-6);
    close(of(&heat, "outer").flow, -flow, 1e-6);
    assert!(heat.lost.abs() <= 1e-6 * flow);
    let conductances = heat.conductances.unwrap();
    close(conductances.rows[0][1], 1.0 / of_spheres(), 1e-6);
    assert_eq!(conductances.rows[0][1], conductances.rows[1][0]);
    assert!(conductances.lost.iter().all(|lost| lost.abs() < 1e-4));
}

#[test]
fn a_heated_sphere_finds_its_temperature() {
    let heat = lumped_and_curved(&spheres("heat_flux = 1000", ""));
    let expected = level(300.0) + 1000.0 * sphere(1.0) * of_spheres();
    close(level(of(&heat, "inner").temperature), expected, 1e-6);
    close(of(&heat, "outer").flow, -1000.0 * sphere(1.0), 1e-6);
    assert!(of(&heat, "inner").is_flow_known && !of(&heat, "inner").is_temperature_known);
}

#[test]
fn a_foil_between_spheres_is_a_shield() {
    let heat = lumped_and_curved(&spheres("temperature = 500", FOIL));
    let [inner, foil, outer] = [1.0, 1.5, 2.0].map(sphere);
    let before = surface_resistance(0.8, inner) + 1.0 / inner + surface_resistance(0.05, foil);
    let after = surface_resistance(0.05, foil) + 1.0 / foil + surface_resistance(0.6, outer);
    let flow = (level(500.0) - level(300.0)) / (before + after);
    close(of(&heat, "inner").flow, flow, 5e-4);
    close(of(&heat, "foil").flow, flow, 5e-4);
    close(of(&heat, "foil:back").flow, -flow, 5e-4);
    for side in ["foil", "foil:back"] {
        close(level(of(&heat, side).temperature), level(500.0) - flow * before, 5e-4);
    }
    assert!(heat.lost.abs() <= 5e-4 * flow);
}

#[test]
fn a_shield_may_have_two_materials() {
    let sides = r#"
        [materials.black]
        emissivity = 0.9
        adiabatic = true
        [[surfaces]]
        name = "foil"
        material = "foil"
        sphere = { center = [0, 0, 0], radius = 1.5 }
        [[surfaces]]
        name = "foil:back"
        material = "black"
        flip = true
        sphere = { center = [0, 0, 0], radius = 1.5 }
    "#;
    let text = spheres("temperature = 500", sides);
    let heat = lumped_and_curved(&text);
    let [inner, foil, outer] = [1.0, 1.5, 2.0].map(sphere);
    let before = surface_resistance(0.8, inner) + 1.0 / inner + surface_resistance(0.9, foil);
    let after = surface_resistance(0.05, foil) + 1.0 / foil + surface_resistance(0.6, outer);
    let flow = (level(500.0) - level(300.0)) / (before + after);
    close(of(&heat, "inner").flow, flow, 5e-4);
    for side in ["foil", "foil:back"] {
        close(level(of(&heat, side).temperature), level(500.0) - flow * before, 5e-4);
    }
}

#[test]
fn a_small_opening_sets_the_level() {
    // All of the heat leaves by a hole of 0.2 × 0.2 in a cube that is heated evenly.
    let text = CUBE
        .replace("temperature = 1000", "heat_flux = 10")
        .replace("temperature = 500", "heat_flux = 10")
        .replace("adiabatic = true", "heat_flux = 10")
        .replace(
            "[1,1,1],[1,0,1]] }",
            "[1,1,1],[1,0,1]], holes = [[[0.4,0.4,1],[0.4,0.6,1],[0.6,0.6,1],[0.6,0.4,1]]] }",
        );
    let heat = at_order(0, &text).unwrap();
    close(heat.lost, 10.0 * (6.0 - 0.04), 1e-9);
    assert!(!heat.is_closed());
}

#[test]
fn a_cylinder_in_a_black_room_sends_out_its_own_alone() {
    // A convex body in a black enclosure at one temperature: Q = ε A σ (T₁⁴ − T₂⁴), whatever their shapes.
    let heat = lumped_and_curved(
        r#"
        materials.rod = { emissivity = 0.3, temperature = 800 }
        materials.wall = { emissivity = 1, temperature = 400 }
        [[surfaces]]
        name = "side"
        material = "rod"
        cylinder = { base = [0, 0, -1], axis = [0, 0, 2], radius = 0.5 }
        [[surfaces]]
        name = "top"
        material = "rod"
        disk = { center = [0, 0, 1], normal = [0, 0, 1], radius = 0.5 }
        [[surfaces]]
        name = "bottom"
        material = "rod"
        disk = { center = [0, 0, -1], normal = [0, 0, -1], radius = 0.5 }
        [[surfaces]]
        name = "wall"
        material = "wall"
        flip = true
        sphere = { center = [0, 0, 0], radius = 3 }
        "#,
    );
    let flux = 0.3 * (level(800.0) - level(400.0));
    for name in ["side", "top", "bottom"] {
        close(of(&heat, name).flux, flux, 1e-4);
    }
}

/// A unit cube with a black floor at 1000 K, a black ceiling at 500 K and adiabatic walls.
const CUBE: &str = r#"
    materials.hot = { emissivity = 1, temperature = 1000 }
    materials.cold = { emissivity = 1, temperature = 500 }
    materials.brick = { emissivity = 0.5, adiabatic = true }
    [[surfaces]]
    name = "floor"
    material = "hot"
    quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
    [[surfaces]]
    name = "ceiling"
    material = "cold"
    quad = { vertices = [[0,0,1],[0,1,1],[1,1,1],[1,0,1]] }
    [[surfaces]]
    name = "wall"
    material = "brick"
    box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true, open = ["bottom", "top"] }
"#;

#[test]
fn adiabatic_walls_pass_on_what_they_receive() {
    let heat = lumped(CUBE);
    // Opposite squares of a cube (Howell's catalogue, C-11): F = 0.199825 by its closed form.
    let pi = std::f64::consts::PI;
    let factor = 2.0 / pi
        * ((4.0_f64 / 3.0).sqrt().ln() + 2.0 * 2.0_f64.sqrt() * (1.0 / 2.0_f64.sqrt()).atan()
            - 2.0 * 1.0_f64.atan());
    // The walls are one node by symmetry, in series between floor and ceiling.
    let flow = 0.5 * (1.0 + factor) * (level(1000.0) - level(500.0));
    close(of(&heat, "floor").flow, flow, 1e-10);
    close(of(&heat, "ceiling").flow, -flow, 1e-10);
    let walls = heat.surfaces.iter().filter(|own| own.name.starts_with("wall"));
    for wall in walls {
        close(level(wall.temperature), 0.5 * (level(1000.0) + level(500.0)), 1e-10);
        assert_eq!(wall.flow, 0.0);
    }
}

#[test]
fn the_error_told_is_that_of_the_order() {
    // A long room that is heated at one end, where nothing is symmetric.
    let text = r#"
    materials.panel = { emissivity = 0.9, temperature = 1300 }
    materials.load = { emissivity = 0.6, temperature = 700 }
    materials.brick = { emissivity = 0.5, adiabatic = true }
    [[surfaces]]
    name = "load"
    material = "load"
    quad = { vertices = [[0,0,0],[3,0,0],[3,2,0],[0,2,0]] }
    [[surfaces]]
    name = "panel"
    material = "panel"
    quad = { vertices = [[0,0,1],[0,2,1],[0.7,2,1],[0.7,0,1]] }
    [[surfaces]]
    name = "roof"
    material = "brick"
    quad = { vertices = [[0.7,0,1],[0.7,2,1],[3,2,1],[3,0,1]] }
    [[surfaces]]
    name = "wall"
    material = "brick"
    box = { origin = [0, 0, 0], size = [3, 2, 1], inward = true, open = ["bottom", "top"] }
    "#;
    let best = at_order(9, text).unwrap();
    for order in 0..5 {
        let heat = at_order(order, text).unwrap();
        for (own, best) in heat.surfaces.iter().zip(&best.surfaces) {
            let [flow, kelvin] = [own.flow - best.flow, own.temperature - best.temperature].map(f64::abs);
            assert!(
                flow <= 2.0 * own.flow_error + 1e-6,
                "{} at order {order}: {flow} told as {}",
                own.name,
                own.flow_error
            );
            assert!(
                kelvin <= 3.0 * own.temperature_error + 1e-6,
                "{} at order {order}: {kelvin} told as {}",
                own.name,
                own.temperature_error
            );
        }
    }
}

#[test]
fn the_field_of_levels_has_the_means_of_the_surfaces() {
    let heat = at_order(3, CUBE).unwrap();
    let levels = heat.levels();
    for (index, own) in heat.surfaces.iter().enumerate() {
        let elements = levels.elements();
        let area: f64 = elements.of_surface(index).map(|element| elements.list()[element].area).sum();
        let sum: f64 = elements
            .of_surface(index)
            .map(|element| {
                let start = elements.starts()[element];
                let constant = &elements.list()[element].constant;
                constant
                    .iter()
                    .zip(&levels.bands()[0].coefficients.radiosity[start..])
                    .map(|(c, b)| c * b)
                    .sum::<f64>()
            })
            .sum();
        close(sum / area, level(own.temperature), 1e-12);
    }
    // A wall is warmer below, beside the hot floor.
    let wall = heat.surfaces.iter().position(|own| own.name.starts_with("wall")).unwrap();
    let element = levels.elements().of_surface(wall).start;
    let patch = &levels.elements().list()[element].patches[0];
    let heights = [patch.node(0.1, 0.1), patch.node(0.9, 0.9)].map(|node| (node.position.z, node));
    let level_at = |node: &radiosity::elements::patch::Node| {
        let place =
            radiosity::solution::Place { surface: wall, parameters: [0.0; 2], position: node.position };
        levels.radiosity(0, element, &place)
    };
    let [low, high] = if heights[0].0 < heights[1].0 { [0, 1] } else { [1, 0] };
    assert!(level_at(&heights[low].1) > level_at(&heights[high].1));
}

#[test]
fn an_isothermal_room_is_at_rest_at_any_order() {
    let text =
        CUBE.replace("temperature = 500", "temperature = 1000").replace("emissivity = 1", "emissivity = 0.4");
    for order in [0, 2, 3] {
        let heat = at_order(order, &text).unwrap();
        assert!(heat.is_closed());
        for own in &heat.surfaces {
            assert!(own.flow.abs() <= 1e-9 * level(1000.0), "{}: {}", own.name, own.flow);
            close(own.temperature, 1000.0, 1e-9);
        }
    }
}

#[test]
fn an_open_plate_loses_its_heat_to_empty_space() {
    let plate = |condition: &str| {
        format!(
            r#"
            materials.plate = {{ emissivity = 0.7, {condition} }}
            [[surfaces]]
            name = "plate"
            material = "plate"
            quad = {{ vertices = [[0,0,0],[2,0,0],[2,1,0],[0,1,0]] }}
            "#
        )
    };
    let warm = lumped(&plate("temperature = 300"));
    close(warm.lost, 2.0 * 0.7 * level(300.0), 1e-12);
    close(warm.conductances.unwrap().lost[0], 1.4, 1e-12);
    // Nothing arrives, so the flux alone sets the temperature.
    let heated = lumped(&plate("heat_flux = 350"));
    close(level(of(&heated, "plate").temperature), 350.0 / 0.7, 1e-12);
}

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
    let error = Scene::from_toml(&CUBE.replace(old, new), "heat.toml")
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
