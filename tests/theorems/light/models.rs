//! Models: blocks that are solved for other materials give what a new solution gives.

use radiosity::Work;
use radiosity::scene::{Material, Scene};
use radiosity::solve::{Direct, Failure, Model, Options, Outcome};
use radiosity_solvers::method::Method;
use radiosity_test_support::scenes::{builtin, material};
use radiosity_test_support::solved::outcome_of;

/// A direct solver, so that what is compared is not a tolerance.
fn options(direct: Direct) -> Options {
    let method = Method::named("cholesky").expect("it is listed");
    Options { order: 2, direct, solver: method, threads: 2, ..Options::default() }
}

fn model(scene: &Scene, options: &Options) -> Model {
    Model::assemble(scene, options, &Work::alone()).expect("the scene has blocks")
}

/// `scene` with the reflectance of the material `name` multiplied by `factor`, and its emission by
/// `brightness`.
fn painted(scene: &Scene, name: &str, factor: f64, brightness: f64) -> Scene {
    let is_own = |own: &&str| *own == name;
    let own = scene.surfaces.iter().find(|own| own.material_name.as_deref().filter(is_own).is_some());
    let Material { reflectance, emission, .. } = own.expect("a surface has that material").material.clone();
    let reflectance = reflectance.iter().map(|rho| factor * rho).collect();
    let emission = emission.iter().map(|exitance| brightness * exitance).collect();
    let material = Material::new(reflectance, emission).expect("it is in range");
    scene.with_material(name, material).expect("it has that material")
}

/// Relative difference of mean irradiances, all surfaces and bands, L2 with the larger of both as the scale.
fn difference(scene: &Scene, a: &Outcome, b: &Outcome) -> f64 {
    let mut worst: f64 = 0.0;
    for band in 0..scene.bands.len() {
        let (mut far, mut scale) = (0.0, 0.0);
        for surface in 0..scene.surfaces.len() {
            let [x, y] = [a, b].map(|outcome| outcome.solution.mean_irradiance(band, surface));
            far += (x - y).powi(2);
            scale += x.powi(2).max(y.powi(2));
        }
        worst = worst.max((far / scale).sqrt());
    }
    worst
}

/// In a closed room of reflectance ρ that emits 1 everywhere, 1 / (1 − ρ) arrives.
#[test]
fn a_furnace_of_any_reflectance_comes_from_one_model() {
    let scene = builtin("furnace-cube");
    let model = model(&scene, &Options { eps: 1e-6, ..options(Direct::Projected) });
    let wall = scene.surfaces[0].material_name.clone().expect("walls have a material");
    for reflectance in [0.0, 0.1, 0.5, 0.9, 0.99] {
        let material = material(reflectance, 1.0);
        let painted = scene.with_material(&wall, material).expect("walls have it");
        let outcome = model.solve(&painted, &Work::alone()).expect("it is solved");
        let exact = 1.0 / (1.0 - reflectance);
        for surface in 0..scene.surfaces.len() {
            let found = outcome.solution.mean_irradiance(0, surface);
            assert!((found - exact).abs() < 1e-4 * exact / (1.0 - reflectance), "{reflectance}: {found}");
        }
        let checks = outcome.checks;
        let balance = checks.energy_in - checks.energy_absorbed - checks.energy_lost;
        assert!(balance.abs() < 1e-9 * checks.energy_absorbed, "{checks:?}");
    }
}

#[test]
fn new_materials_give_the_solution_of_the_new_scene() {
    let scene = builtin("cornell-box");
    let options = options(Direct::Projected);
    let model = model(&scene, &options);
    for (name, factor, brightness) in [("white", 1.2, 1.0), ("red", 0.0, 1.0), ("light", 0.5, 3.0)] {
        let painted = painted(&scene, name, factor, brightness);
        let again = model.solve(&painted, &Work::alone()).expect("it is solved");
        let far = difference(&scene, &again, &outcome_of(&painted, &options));
        assert!(far < 1e-12, "{name}: {far:e}");
    }
}

/// Reflected light that is not gathered anew differs from what is by a part of its tolerance.
#[test]
fn new_reflectances_keep_the_accuracy_of_light_that_is_split_off() {
    let scene = builtin("cornell-box");
    let options = options(Direct::Split);
    let model = model(&scene, &options);
    let changes =
        [("white", 1.25), ("white", 0.25), ("red", 1.5), ("green", 0.25), ("light", 0.26), ("red", 0.0)];
    for (name, factor) in changes {
        let painted = painted(&scene, name, factor, 1.0);
        let again = model.solve(&painted, &Work::alone()).expect("it is solved");
        let far = difference(&scene, &again, &outcome_of(&painted, &options));
        assert!(far < 0.5 * options.shadow_eps, "{name}: {far:e}");
    }
}

#[test]
fn new_emission_gives_the_solution_of_the_new_scene_where_direct_light_is_split_off() {
    let scene = builtin("cornell-box");
    let options = options(Direct::Split);
    let painted = painted(&scene, "light", 1.0, 3.0);
    let again = model(&scene, &options).solve(&painted, &Work::alone()).expect("it is solved");
    let far = difference(&scene, &again, &outcome_of(&painted, &options));
    assert!(far < 1e-12, "{far:e}");
}

#[test]
fn scenes_that_a_model_is_not_made_for_are_refused() {
    let scene = builtin("cornell-box");
    let model = model(&scene, &options(Direct::Auto));
    let other = model.solve(&builtin("empty-box"), &Work::alone()).expect_err("it is another scene");
    assert!(matches!(&other, Failure::OtherSurface { .. }), "{other}");
    // The same text read again has surfaces of its own, which may have been changed.
    let again = model.solve(&builtin("cornell-box"), &Work::alone()).expect_err("it was read again");
    assert!(matches!(&again, Failure::OtherSurface { surface } if surface == "floor"), "{again}");
    let black = Material::new(vec![0.0; 3], vec![0.0; 3]).expect("it is in range");
    let dark = scene.with_material("red", black).expect("a wall has it");
    let unlit = self::model(&dark, &options(Direct::Auto));
    let unlit = unlit.solve(&painted_from(&dark, &scene), &Work::alone()).expect_err("a wall had no blocks");
    assert!(matches!(&unlit, Failure::Unlit { surface } if surface == "left_wall"), "{unlit}");
}

/// `scene` with the red of `other`.
fn painted_from(scene: &Scene, other: &Scene) -> Scene {
    let red = other.surfaces.iter().find(|own| own.material_name.as_deref() == Some("red"));
    let red = red.expect("a wall is red").material.clone();
    scene.with_material("red", red).expect("a wall has it")
}
