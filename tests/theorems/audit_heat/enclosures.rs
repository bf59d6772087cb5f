//! Enclosures of known view factors, and rooms at rest.

use std::f64::consts::PI;

use radiosity::Work;
use radiosity::audit::{Effort, HeatReferee, ViewFactorReferee};
use radiosity_test_support::scenes::typed;

use super::scored::{SEEN, Scored, heat, heat_of, level, of};

#[test]
fn black_walls_of_a_can_exchange_by_view_factors() {
    let text = r#"
        materials.hot = { emissivity = 1, temperature = 1000 }
        materials.warm = { emissivity = 1, temperature = 700 }
        materials.cold = { emissivity = 1, temperature = 400 }
        [[surfaces]]
        name = "wall"
        material = "warm"
        flip = true
        cylinder = { base = [0, 0, 0], axis = [0, 0, 2], radius = 1 }
        [[surfaces]]
        name = "bottom"
        material = "hot"
        disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }
        [[surfaces]]
        name = "top"
        material = "cold"
        disk = { center = [0, 0, 2], normal = [0, 0, -1], radius = 1 }
    "#;
    // Coaxial disks of radius 1 at the distance 2 (Howell's catalogue, C-40): 3 − 2 √2.
    let opposite = 3.0 - 2.0 * 2f64.sqrt();
    let wall = 1.0 - opposite;
    let [hot, warm, cold] = [1000.0, 700.0, 400.0].map(level);
    let bottom = PI * (hot - wall * warm - opposite * cold);
    let top = PI * (cold - wall * warm - opposite * hot);
    let mut scored = Scored::default();
    for seed in 0..100 {
        let found = heat(text, 1024.0, seed);
        scored.add("bottom", &of(&found, "bottom").flow, bottom);
        scored.add("top", &of(&found, "top").flow, top);
        scored.add("wall", &of(&found, "wall").flow, -bottom - top);
    }
    scored.check(300);
}

#[test]
fn a_bowl_radiates_into_empty_space() {
    // The inside of a half sphere sees itself by ½, evenly: q = J/2, J (1 − (1 − ε)/2) = ε σ T⁴.
    let text = r#"
        materials.bowl = { emissivity = 0.4, temperature = 773 }
        [[surfaces]]
        name = "bowl"
        material = "bowl"
        flip = true
        sphere = { center = [0, 0, 0], radius = 0.15, z = [0, 0.15] }
    "#;
    let radiosity = 0.4 * level(773.0) / (1.0 - 0.6 * 0.5);
    let mut scored = Scored::default();
    for seed in 0..120 {
        scored.add("bowl", &of(&heat(text, 1024.0, seed), "bowl").flux, 0.5 * radiosity);
    }
    scored.check(120);
}

#[test]
fn a_room_of_one_temperature_is_at_rest_without_noise() {
    let text = r#"
        materials.grey = { emissivity = 0.4, temperature = 1000 }
        materials.brick = { emissivity = 0.5, adiabatic = true }
        [[surfaces]]
        name = "floor"
        material = "grey"
        quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
        [[surfaces]]
        name = "ball"
        material = "grey"
        sphere = { center = [0.5, 0.5, 0.3], radius = 0.2 }
        [[surfaces]]
        name = "shield"
        material = "brick"
        two_sided = true
        parallelogram = { origin = [0.2, 0.2, 0.7], edge1 = [0.5, 0, 0], edge2 = [0, 0.5, 0.1] }
        [[surfaces]]
        name = "wall"
        material = "brick"
        box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true, open = ["bottom"] }
    "#;
    for (name, own) in heat(text, 64.0, 0) {
        let level = level(1000.0);
        assert!((own.level.value / level - 1.0).abs() < 1e-12, "{name}: {:?}", own.level);
        assert!((own.temperature.value - 1000.0).abs() < 1e-9, "{name}: {:?}", own.temperature);
        assert!(own.level.error.max(own.flux.error) < 1e-12 * level, "{name}: {own:?}");
        assert!(own.flux.value.abs() < 1e-12 * level, "{name}: {:?}", own.flux);
    }
}

#[test]
fn what_stands_on_a_sheet_takes_its_place() {
    // Half of the upper side of a heated sheet lies under a cold block. Nothing arrives anywhere, so that
    // with the flux per area of the bare front, A/2, q A/2 = ε A/2 σ T⁴ + ε A σ T⁴.
    let text = r#"
        materials.foil = { emissivity = 0.5 }
        materials.cold = { emissivity = 1, temperature = 0 }
        [[surfaces]]
        name = "sheet"
        material = "foil"
        two_sided = true
        heat_flux = 100
        parallelogram = { origin = [0, 0, 0], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }
        [[surfaces]]
        name = "block"
        material = "cold"
        box = { origin = [0.5, 0, 0], size = [0.5, 1, 0.5] }
    "#;
    let found = heat(text, 1024.0, 0);
    let expected = 0.5 * 100.0 / (0.5 * 1.5);
    let [front, back] = ["sheet", "sheet:back"].map(|name| of(&found, name));
    assert!((front.level.value / expected - 1.0).abs() < 2e-3, "{:?} for {expected}", front.level);
    for (side, flow) in [(front, 0.25 * expected), (back, 0.5 * expected)] {
        let off = (side.flow.value - flow).abs();
        assert!(off <= SEEN * side.flow.error + 2e-3 * flow, "{:?} for {flow}", side.flow);
        assert!(side.flow.error < 2e-2 * flow, "{:?}", side.flow);
    }
}

#[test]
fn what_only_touches_a_surface_takes_no_part_of_it() {
    // Within the acute corners of a long duct walls come as near as walks start.
    let text = r#"
        materials.cold = { emissivity = 0.5, temperature = 300 }
        materials.hot = { emissivity = 0.8, heat_flux = 1000 }
        [[surfaces]]
        name = "floor"
        material = "cold"
        quad = { vertices = [[0,0,0],[1,0,0],[1,1000,0],[0,1000,0]] }
        [[surfaces]]
        name = "slope"
        material = "hot"
        quad = { vertices = [[0,0,0],[0,1000,0],[1,1000,0.5],[1,0,0.5]] }
    "#;
    let found = heat_of("slope", text, 65536.0, 0);
    let flow = 1000.0 * 1.25_f64.sqrt() * 1000.0;
    assert!((found.flow.value / flow - 1.0).abs() < 1e-12, "{:?} for {flow}", found.flow);
    // Something of the margin was met.
    assert!(found.flow.error > 1e-6 * flow && found.flow.error < 1e-3 * flow, "{:?}", found.flow);
}

#[test]
fn heat_and_view_factors_are_alike_on_any_threads() {
    let text = r#"
        materials.hot = { emissivity = 0.7, temperature = 1000 }
        materials.foil = { emissivity = 0.3, heat_flux = 20 }
        [[surfaces]]
        name = "ball"
        material = "hot"
        sphere = { center = [0, 0, 1], radius = 0.5 }
        [[surfaces]]
        name = "foil"
        material = "foil"
        two_sided = true
        disk = { center = [0, 0, 0], normal = [0, 1, 3], radius = 1 }
    "#;
    let scene = typed(text);
    let effort = Effort::of_walks(256.0).seeded(3);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let heat = HeatReferee::of(&scene).expect("it has a temperature");
            let factors = ViewFactorReferee::of(&scene);
            (
                heat.estimates(&[0, 1, 2], &effort, &Work::alone()),
                factors.rows(&[0, 1, 2], &effort, &Work::alone()),
            )
        })
    };
    assert_eq!(run(1), run(3));
}
