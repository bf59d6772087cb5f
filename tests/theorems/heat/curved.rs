//! Curved surfaces, most of whose view factors follow from sums and reciprocity.

use radiosity_test_support::compare::assert_close;
use std::f64::consts::{FRAC_PI_2, PI};

use super::shared::{level, lumped_and_curved, of, to_accuracy};

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
    assert_close(of(&heat, "inner").flow, flow, 1e-10);
    assert_close(of(&heat, "outer").flow, -flow, 1e-10);
    assert!(heat.lost.abs() <= 1e-10 * flow);
    let conductances = heat.conductances.unwrap();
    assert_close(conductances.rows[0][1], 1.0 / of_spheres(), 1e-10);
    assert_eq!(conductances.rows[0][1], conductances.rows[1][0]);
    assert!(conductances.lost.iter().all(|lost| lost.abs() < 1e-10));
}

#[test]
fn a_heated_sphere_finds_its_temperature() {
    let heat = lumped_and_curved(&spheres("heat_flux = 1000", ""));
    let expected = level(300.0) + 1000.0 * sphere(1.0) * of_spheres();
    assert_close(level(of(&heat, "inner").temperature), expected, 1e-10);
    assert_close(of(&heat, "outer").flow, -1000.0 * sphere(1.0), 1e-10);
    assert!(of(&heat, "inner").is_flow_known && !of(&heat, "inner").is_temperature_known);
}

#[test]
fn a_foil_between_spheres_is_a_shield() {
    let heat = lumped_and_curved(&spheres("temperature = 500", FOIL));
    let [inner, foil, outer] = [1.0, 1.5, 2.0].map(sphere);
    let before = surface_resistance(0.8, inner) + 1.0 / inner + surface_resistance(0.05, foil);
    let after = surface_resistance(0.05, foil) + 1.0 / foil + surface_resistance(0.6, outer);
    let flow = (level(500.0) - level(300.0)) / (before + after);
    assert_close(of(&heat, "inner").flow, flow, 1e-10);
    assert_close(of(&heat, "foil").flow, flow, 1e-10);
    assert_close(of(&heat, "foil:back").flow, -flow, 1e-10);
    for side in ["foil", "foil:back"] {
        assert_close(level(of(&heat, side).temperature), level(500.0) - flow * before, 1e-10);
    }
    assert!(heat.lost.abs() <= 1e-10 * flow);
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
    assert_close(of(&heat, "inner").flow, flow, 1e-10);
    for side in ["foil", "foil:back"] {
        assert_close(level(of(&heat, side).temperature), level(500.0) - flow * before, 1e-10);
    }
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
        assert_close(of(&heat, name).flux, flux, 1e-10);
    }
}

/// Coaxial cylinders of radii 1 and 2 and of length 4, closed by rings.
const PIPES: &str = r#"
    materials.hot = { emissivity = 0.8, temperature = 500 }
    materials.cold = { emissivity = 0.6, temperature = 300 }
    materials.brick = { emissivity = 0.5, adiabatic = true }
    [[surfaces]]
    name = "inner"
    material = "hot"
    cylinder = { base = [0, 0, 0], axis = [0, 0, 4], radius = 1 }
    [[surfaces]]
    name = "outer"
    material = "cold"
    flip = true
    cylinder = { base = [0, 0, 0], axis = [0, 0, 4], radius = 2 }
    [[surfaces]]
    name = "low"
    material = "brick"
    disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 2, inner_radius = 1 }
    [[surfaces]]
    name = "high"
    material = "brick"
    disk = { center = [0, 0, 4], normal = [0, 0, -1], radius = 2, inner_radius = 1 }
"#;

/// F₂₁ and F₂₂ of the outer of two coaxial cylinders (Howell's catalogue, C-91), for radii 1 and R and the
/// length H.
fn of_outer_cylinder(r: f64, h: f64) -> [f64; 2] {
    let (a, b) = (h * h + r * r - 1.0, h * h - r * r + 1.0);
    let arc = ((a + 2.0).powi(2) - 4.0 * r * r).sqrt() * (b / (r * a)).acos();
    let inner = (1.0 - ((b / a).acos() - (arc + b * (1.0 / r).asin() - FRAC_PI_2 * a) / (2.0 * h)) / PI) / r;
    let root = (4.0 * r * r + h * h).sqrt() / h;
    let sine = (4.0 * (r * r - 1.0) + h * h * (1.0 - 2.0 / (r * r))) / (h * h + 4.0 * (r * r - 1.0));
    let arcs = root * sine.asin() - (1.0 - 2.0 / (r * r)).asin() + FRAC_PI_2 * (root - 1.0);
    let own =
        1.0 - 1.0 / r + 2.0 / (PI * r) * (2.0 * (r * r - 1.0).sqrt() / h).atan() - h / (2.0 * PI * r) * arcs;
    [inner, own]
}

#[test]
fn pipes_closed_by_rings_exchange_what_their_network_lets_through() {
    let heat = lumped_and_curved(PIPES);
    let [inner, outer] = [8.0 * PI, 16.0 * PI];
    let [to_inner, to_itself] = of_outer_cylinder(2.0, 4.0);
    let direct = outer * to_inner;
    let [from_inner, from_outer] = [inner - direct, outer * (1.0 - to_inner - to_itself)];
    let between = direct + 1.0 / (1.0 / from_inner + 1.0 / from_outer);
    let resistance = surface_resistance(0.8, inner) + 1.0 / between + surface_resistance(0.6, outer);
    let flow = (level(500.0) - level(300.0)) / resistance;
    assert_close(of(&heat, "inner").flow, flow, 1e-4);
    assert!(heat.lost.abs() <= 1e-11 * flow, "{}", heat.lost);
}

#[test]
fn a_closed_scene_neither_makes_nor_loses_heat() {
    // Rough transfers, at any order, with no symmetry.
    let text = format!(
        "{PIPES}{}",
        r#"
        [[surfaces]]
        name = "ball"
        material = "hot"
        sphere = { center = [1.5, 0.1, 1], radius = 0.3 }
        "#
    );
    for order in [0, 1, 2] {
        let heat = to_accuracy(1e-2, order, &text).unwrap();
        let exchanged: f64 = heat.surfaces.iter().map(|own| own.flow.max(0.0)).sum();
        assert!(heat.lost.abs() <= 1e-10 * exchanged, "{} W of {exchanged} at order {order}", heat.lost);
        let moved = heat.moved.expect("the scene is closed");
        assert!(moved > 1e-9 && moved < 1e-1, "{moved}");
        let conductances = heat.conductances.unwrap();
        assert!(conductances.lost.iter().all(|lost| lost.abs() <= 1e-10), "{:?}", conductances.lost);
    }
}

#[test]
fn what_only_looks_closed_is_left_as_it_is() {
    // The outer ball shows its back, which is adiabatic, and loses heat by its front.
    let text = spheres("temperature = 500", "").replace("flip = true", "");
    let heat = lumped_and_curved(&text);
    assert!(!heat.is_closed());
    assert_close(heat.lost, 0.6 * level(300.0) * sphere(2.0), 1e-10);
    assert_close(of(&heat, "outer:back").temperature, 500.0, 1e-10);
    // A lid is missing.
    let (open, _) = PIPES.split_at(PIPES.rfind("[[surfaces]]").unwrap());
    let heat = lumped_and_curved(open);
    assert!(heat.moved.is_none() && heat.lost > 0.0);
}

/// Clausing's tube of the length of its diameter between a black disk at 1000 K and one at 0 K passes 0.5142305345 of
/// what the disk sends out (his integral equation, Ann. Phys. 12, 1932, to ten digits).
#[test]
fn the_error_of_a_tube_is_told_within_a_factor() {
    let text = r#"
    materials.hot = { emissivity = 1, temperature = 1000 }
    materials.cold = { emissivity = 1, temperature = 0 }
    materials.wall = { emissivity = 0.5, adiabatic = true }
    [[surfaces]]
    name = "wall"
    material = "wall"
    flip = true
    cylinder = { base = [0,0,0], axis = [0,0,2], radius = 1 }
    [[surfaces]]
    name = "bottom"
    material = "hot"
    disk = { center = [0,0,0], normal = [0,0,1], radius = 1 }
    [[surfaces]]
    name = "top"
    material = "cold"
    disk = { center = [0,0,2], normal = [0,0,-1], radius = 1 }
    "#;
    let flow = 0.5142305345 * std::f64::consts::PI * level(1000.0);
    for order in [0, 3] {
        let heat = to_accuracy(1e-4, order, text).unwrap_or_else(|error| panic!("{error}"));
        let own = of(&heat, "bottom");
        let ratio = own.flow_error / (own.flow - flow).abs();
        assert!(heat.is_cut && (0.5..10.0).contains(&ratio), "order {order}: {ratio} of the true error");
    }
}
