//! The built-in scenes: what is in them, that they are closed where they should be, and what their parameters
//! do.

use std::f64::consts::PI;

use proptest::prelude::*;
use radiosity::kernel::Accuracy;
use radiosity::language::read;
use radiosity::scene::FaultKind;
use radiosity::solve::Options;
use radiosity::solve::solution::SurfacePlace;
use radiosity::visibility::Visibility;
use radiosity_geom::{DVec3, Encounter, Ray};
use radiosity_test_support::scenes::builtin_with;
use radiosity_test_support::solved::{blocks_of, elements_of, outcome_of};

#[test]
fn every_scene_loads_with_every_parameter_at_its_ends() {
    for builtin in radiosity::language::builtins() {
        let scene = builtin_with(builtin.name, &[]);
        assert!(scene.title.is_some() && scene.camera.is_some(), "{}", builtin.name);
        scene.require_light().expect("a built-in scene has a lamp");
        for parameter in builtin.parameters {
            for value in parameter.range {
                builtin_with(builtin.name, &[(parameter.name, value)]);
            }
        }
    }
}

#[test]
fn scenes_hold_what_they_are_said_to() {
    let count = |name: &str| builtin_with(name, &[]).surfaces.len();
    let counts =
        ["occluder-box", "two-boxes", "teapot", "furnace-sphere", "parallel-squares", "hinge-squares"];
    assert_eq!(counts.map(count), [9, 17, 40, 1, 2, 2]);
    let temple = builtin_with("temple", &[]);
    assert!(temple.surfaces.len() >= 600);
    let of_kind = |kind: &str| temple.surfaces.iter().filter(|surface| surface.kind == kind).count();
    // Sixteen columns of four sides; fourteen lamps; the vault.
    assert_eq!(of_kind("cylinder"), 16 * 4 + 14 + 1);
    assert!(of_kind("extrusion") > 0 && of_kind("rational") > 0 && of_kind("parallelogram") > 0);
    let lamps = temple.surfaces.iter().filter(|surface| surface.material.emits());
    assert!(lamps.clone().all(|lamp| lamp.order == Some(13)));
    assert_eq!(lamps.count(), 14);
}

#[test]
fn settings_are_refused_with_a_reason() {
    let fault = |name: &str, settings: &[(&str, f64)]| {
        radiosity::language::source(name, settings).and_then(|source| read(&source)).unwrap_err().fault
    };
    let unknown = radiosity::language::source("parallel-squares", &[("distanse", 1.0)]).unwrap_err();
    assert!(unknown.cure().expect("there is a cure").contains("\"distance\""));
    let refused = |name: &str, settings: &[(&str, f64)], kind: FaultKind, cause: &str| {
        let fault = fault(name, settings);
        assert!(fault.kind == kind && fault.to_string().contains(cause), "{fault}");
    };
    let outside = "outside 0 ≤ reflectance ≤ 0.99";
    refused("cornell-box", &[("distance", 1.0)], FaultKind::UnknownName, "no parameter \"distance\"");
    refused("furnace-cube", &[("reflectance", 1.0)], FaultKind::OutOfRange, outside);
    refused("furnace-cube", &[("reflectance", f64::NAN)], FaultKind::OutOfRange, outside);
    refused("temple", &[("bays", 4.5)], FaultKind::NotWhole, "4.5 is not a whole number");
    refused("examples/office.toml", &[("bays", 4.0)], FaultKind::UnknownName, "the scene has no variables");
    refused("temples", &[("bays", 4.0)], FaultKind::UnknownName, "unknown scene \"temples\"");
}

/// The area is that of the table, computed elsewhere to 9 digits; the rule there is good to 3e-6 on folded
/// patches.
#[test]
fn the_teapot_is_the_table_s_and_faces_outward() {
    let scene = builtin_with("teapot", &[]);
    let pot: Vec<_> = scene.surfaces.iter().filter(|surface| surface.kind == "patches").collect();
    assert_eq!(pot.len(), 32);
    let area: f64 = pot.iter().map(|patch| patch.shape.area()).sum();
    assert!((area - 52.882757002).abs() < 3e-6 * area, "{area}");
    for patch in &pot[4..12] {
        let center = patch.shape.jet(0.0, 0.0);
        assert!(center.normal.dot(center.position.with_z(0.0)) > 0.0, "{} faces inward", patch.name);
    }
}

#[test]
fn the_teapot_s_height_is_set() {
    let highest = |height: f64| {
        let scene = builtin_with("teapot", &[("height", height)]);
        let pot = scene.surfaces.iter().filter(|surface| surface.kind == "patches");
        let corners = pot.flat_map(|patch| [-1.0, 1.0].map(|u| patch.shape.jet(u, 1.0).position.z));
        corners.fold(0.0, f64::max)
    };
    assert!((highest(1.3) - 1.3 * highest(1.0)).abs() < 1e-12);
}

/// Rays from the camera meet nothing but fronts in a closed room.
fn sees_fronts_only(name: &str, settings: &[(&str, f64)], directions: &[DVec3]) {
    let scene = builtin_with(name, settings);
    let eye = scene.camera.as_ref().expect("there is a camera").eye;
    let visibility = Visibility::open(&scene);
    for direction in directions {
        let Encounter { surface, hit, .. } = visibility
            .nearest(&Ray::new(eye, *direction))
            .unwrap_or_else(|| panic!("{name} is open towards {direction}"));
        let normal = scene.surfaces[surface].shape.jet(hit.u, hit.v).normal;
        let name = &scene.surfaces[surface].name;
        assert!(normal.dot(*direction) <= 0.0, "{name} is seen from behind towards {direction}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn rooms_are_closed_and_face_inward(
        directions in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 200),
    ) {
        let directions: Vec<DVec3> = directions
            .into_iter()
            .map(DVec3::from_array)
            .filter(|direction| direction.length() > 0.1)
            .collect();
        let rooms =
            ["empty-box", "occluder-box", "two-boxes", "furnace-cube", "furnace-sphere"].map(|room| (room, &[][..]));
        for (room, settings) in rooms.into_iter().chain([("temple", &[("bays", 4.0)][..])]) {
            sees_fronts_only(room, settings, &directions);
        }
    }
}

/// The form factor of the two squares of a scene.
fn factor(name: &str, settings: &[(&str, f64)]) -> f64 {
    let scene = builtin_with(name, settings);
    let elements = elements_of(&scene, 0, 1);
    let visibility = Visibility::open(&scene);
    let accuracy = Accuracy { eps: 1e-3, shadow_eps: 1e-3 };
    let blocks = blocks_of(&elements, &visibility, accuracy);
    blocks.iter().find(|block| block.row != block.column).map_or(0.0, |block| block.values[0])
}

/// Two unit squares face to face: 2/(πX²) [ln √((1+X²)²/(1+2X²)) + 2X√(1+X²) atan(X/√(1+X²)) − 2X atan X],
/// X = 1/d (Howell's catalogue, C-11).
#[test]
fn parallel_squares_exchange_the_closed_form() {
    for distance in [0.05, 0.1, 1.0, 3.0, 10.0] {
        let x: f64 = 1.0 / distance;
        let (square, root) = (1.0 + x * x, (1.0 + x * x).sqrt());
        let exact = 2.0 / (PI * x * x)
            * ((square * square / (1.0 + 2.0 * x * x)).sqrt().ln() + 2.0 * x * root * (x / root).atan()
                - 2.0 * x * x.atan());
        let found = factor("parallel-squares", &[("distance", distance)]);
        assert!((found - exact).abs() < 1e-11, "{distance}: {found} {exact}");
    }
}

/// Perpendicular unit squares with a common edge: ½ + (¼ ln ¾ − √2 atan(1/√2)) / π, from Howell's C-14.
#[test]
fn hinged_squares_exchange_the_closed_form_and_less_the_wider_they_open() {
    let root = 2f64.sqrt();
    let perpendicular = 0.5 + (0.25 * 0.75f64.ln() - root * (1.0 / root).atan()) / PI;
    let found = factor("hinge-squares", &[]);
    assert!((found - perpendicular).abs() < 1e-11, "{found} {perpendicular}");
    let opened =
        [10.0, 30.0, 60.0, 90.0, 120.0, 150.0].map(|angle| factor("hinge-squares", &[("angle", angle)]));
    assert!(opened.windows(2).all(|pair| pair[0] > pair[1]), "{opened:?}");
    assert_eq!(factor("hinge-squares", &[("angle", 180.0)]), 0.0);
}

/// A closed room of reflectance ρ that emits 1 everywhere has the radiosity 1 / (1 − ρ).
#[test]
fn furnaces_have_one_radiosity() {
    for (name, reflectance) in [("furnace-cube", 0.0), ("furnace-cube", 0.9), ("furnace-sphere", 0.7)] {
        let scene = builtin_with(name, &[("reflectance", reflectance)]);
        let outcome = outcome_of(&scene, &Options { order: 2, ..Options::default() });
        let elements = outcome.solution.elements();
        for (index, element) in elements.list().iter().enumerate() {
            for parameters in [[0.0, 0.0], [0.9, -0.9], [-0.5, 0.3]] {
                let position = elements.shape(element.surface).jet(parameters[0], parameters[1]).position;
                let place = SurfacePlace { surface: element.surface, parameters, position };
                let error = outcome.solution.radiosity(0, index, &place) * (1.0 - reflectance) - 1.0;
                assert!(error.abs() < 1e-2, "{name}, {reflectance}: {error}");
            }
        }
    }
}

/// Closed rooms with things in them keep their light but for the error of sampled shadows.
#[test]
fn rooms_with_shadows_lose_little() {
    for name in ["occluder-box", "two-boxes"] {
        let scene = builtin_with(name, &[]);
        let outcome = outcome_of(&scene, &Options { order: 2, ..Options::default() });
        let lost = outcome.checks.energy_lost / outcome.checks.energy_in;
        assert!(lost.abs() < 0.02, "{name}: {lost}");
    }
}
