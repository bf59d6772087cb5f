//! Flat enclosures, and what any balance keeps.

use radiosity::solve::solution::SurfacePlace;
use radiosity_test_support::compare::assert_close;

use super::shared::{CUBE, at_order, level, lumped, of};

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
    assert_close(of(&heat, "floor").flow, flow, 1e-10);
    assert_close(of(&heat, "ceiling").flow, -flow, 1e-10);
    let walls = heat.surfaces.iter().filter(|own| own.name.starts_with("wall"));
    for wall in walls {
        assert_close(level(wall.temperature), 0.5 * (level(1000.0) + level(500.0)), 1e-10);
        assert_eq!(wall.flow, 0.0);
    }
}

/// As networks: (1 − ε)/ε before floor and ceiling each, and between them 2/(1 + F₁₂) by the walls.
#[test]
fn enclosures_of_any_emissivity_are_in_balance() {
    let between = 2.0 / (1.0 + 0.199_824_895_698_387);
    for emissivity in [1.0, 1e-3, 1e-6, 1e-9] {
        let heat = lumped(&CUBE.replace("emissivity = 1,", &format!("emissivity = {emissivity:e},")));
        let flow = (level(1000.0) - level(500.0)) / (2.0 * (1.0 - emissivity) / emissivity + between);
        for (name, flow) in [("floor", flow), ("ceiling", -flow)] {
            let own = of(&heat, name);
            let off = (own.flow - flow).abs();
            assert!(off <= own.flow_error + 1e-10 * flow.abs(), "{emissivity}: {own:?} for {flow}");
            // Where much is absorbed, what varies over walls is told, which networks leave out.
            assert!(emissivity > 1e-6 || own.flow_error <= 1e-4 * flow.abs(), "{emissivity}: {own:?}");
        }
        assert!(heat.is_closed(), "{emissivity}: lost {}", heat.lost);
    }
}

#[test]
fn the_error_told_is_that_of_the_elements() {
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
                kelvin <= 4.0 * own.temperature_error + 1e-6,
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
        assert_close(sum / area, level(own.temperature), 1e-12);
    }
    // A wall is warmer below, beside the hot floor.
    let wall = heat.surfaces.iter().position(|own| own.name.starts_with("wall")).unwrap();
    let element = levels.elements().of_surface(wall).start;
    let patch = &levels.elements().list()[element].patches[0];
    let heights = [patch.node(0.1, 0.1), patch.node(0.9, 0.9)].map(|node| (node.position.z, node));
    let level_at = |node: &radiosity::elements::patch::Node| {
        let place = SurfacePlace { surface: wall, parameters: [0.0; 2], position: node.position };
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
            assert_close(own.temperature, 1000.0, 1e-9);
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
    assert_close(warm.lost, 2.0 * 0.7 * level(300.0), 1e-12);
    assert_close(warm.conductances.unwrap().lost[0], 1.4, 1e-12);
    // Nothing arrives, so the flux alone sets the temperature.
    let heated = lumped(&plate("heat_flux = 350"));
    assert_close(level(of(&heated, "plate").temperature), 350.0 / 0.7, 1e-12);
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
    assert_close(heat.lost, 10.0 * (6.0 - 0.04), 1e-9);
    assert!(!heat.is_closed() && heat.moved.is_none());
}
