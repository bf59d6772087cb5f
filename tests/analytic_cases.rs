//! Whole solutions with closed forms, or spectrally converged, through the library.
//!
//! The references of plates and disks were computed by a Nyström method to 1e-15; the others are exact: in a sphere the
//! irradiance is one number, in a closed room of one reflectance B = 1/(1 − ρ).

use radiosity::scene::Scene;
use radiosity::solution::Place;
use radiosity::solve::{Options, Outcome, solve};

fn solved(scene: &str, order: usize, eps: f64) -> (Scene, Outcome) {
    let scene =
        Scene::from_toml(&format!("bands = [\"grey\"]\n{scene}"), "case").expect("the scene is right");
    let options = Options { order, subdivide: Some(1), eps, ..Options::default() };
    let outcome = solve(&scene, &options, &|_| {}).expect("it can be solved");
    (scene, outcome)
}

/// Radiosity of a surface at its parameters, from the polynomials.
fn radiosity((scene, outcome): &(Scene, Outcome), surface: usize, parameters: [f64; 2]) -> f64 {
    let element = outcome.solution.elements().at(surface, parameters).expect("it is on the surface");
    let position = scene.surfaces[surface].shape.jet(parameters[0], parameters[1]).position;
    outcome.solution.radiosity(0, element, &Place { surface, parameters, position })
}

#[track_caller]
fn assert_close(found: f64, exact: f64, relative: f64) {
    assert!((found / exact - 1.0).abs() <= relative, "{found} instead of {exact}");
}

#[test]
fn zones_of_a_sphere_get_the_same_light() {
    let zones = |radius: f64, cut: f64, reflectance: [f64; 2], emission: [f64; 2]| {
        solved(
            &format!(
                "[materials.low]\nreflectance = {}\nemission = {}\n[materials.high]\nreflectance = {}\nemission = {}
                 [[surfaces]]\nmaterial = 'low'\nflip = true
                 sphere = {{ center = [0, 0, 0], radius = {radius}, z = [{}, {cut}] }}
                 [[surfaces]]\nmaterial = 'high'\nflip = true
                 sphere = {{ center = [0, 0, 0], radius = {radius}, z = [{cut}, {radius}] }}",
                reflectance[0], emission[0], reflectance[1], emission[1], -radius
            ),
            2,
            1e-6,
        )
    };
    let halves = zones(1.0, 0.0, [0.5, 0.5], [1.0, 0.0]);
    let cap = zones(2.0, 1.6, [0.7, 0.2], [0.0, 10.0]);
    for at in [[0.0, 0.0], [-0.9, 0.7], [0.3, -0.8]] {
        assert_close(radiosity(&halves, 0, at), 1.5, 1e-6);
        assert_close(radiosity(&halves, 1, at), 0.5, 1e-6);
        assert_close(radiosity(&cap, 0, at), 2.0, 1e-6);
        assert_close(radiosity(&cap, 1, at), 74.0 / 7.0, 1e-6);
    }
}

#[test]
fn concentric_spheres_exchange_and_the_inner_one_blocks() {
    let spheres = solved(
        "[materials.inner]\nreflectance = 0.3\nemission = 1\n[materials.outer]\nreflectance = 0.6
         [[surfaces]]\nmaterial = 'inner'\nsphere = { center = [0, 0, 0], radius = 0.5 }
         [[surfaces]]\nmaterial = 'outer'\nflip = true\nsphere = { center = [0, 0, 0], radius = 1 }",
        0,
        1e-5,
    );
    assert_close(radiosity(&spheres, 0, [0.0, 0.0]), 1.089_108_910_891_089_2, 1e-6);
    assert_close(radiosity(&spheres, 1, [0.0, 0.0]), 0.297_029_702_970_297, 1e-6);
}

#[test]
fn a_can_is_a_furnace() {
    for (reflectance, exact) in [(0.5, 2.0), (0.9, 10.0)] {
        let can = solved(
            &format!(
                "[materials.white]\nreflectance = {reflectance}\nemission = 1
                 [[surfaces]]\nmaterial = 'white'\nflip = true
                 cylinder = {{ base = [0, 0, 0], axis = [0, 0, 1], radius = 1 }}
                 [[surfaces]]\nmaterial = 'white'\ndisk = {{ center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }}
                 [[surfaces]]\nmaterial = 'white'\ndisk = {{ center = [0, 0, 1], normal = [0, 0, -1], radius = 1 }}"
            ),
            1,
            1e-8,
        );
        for surface in 0..3 {
            assert_close(radiosity(&can, surface, [0.2, -0.6]), exact, 1e-6);
        }
    }
}

#[test]
fn parallel_plates_have_the_radiosity_of_the_reference() {
    let plates = solved(
        "[materials.warm]\nreflectance = 0.5\nemission = 1\n[materials.cold]\nreflectance = 0.5
         [[surfaces]]\nmaterial = 'warm'\nparallelogram = { origin = [0, 0, 0], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }
         [[surfaces]]\nmaterial = 'cold'\nflip = true
         parallelogram = { origin = [0, 0, 1], edge1 = [1, 0, 0], edge2 = [0, 1, 0] }",
        10,
        1e-8,
    );
    let reference = [
        ([0.0, 0.0], 1.007_006_348_356_019, 0.069_975_044_789_025_66),
        ([0.5, 0.0], 1.009_191_215_807_359, 0.091_115_016_656_157_84),
        ([0.5, 0.5], 1.012_326_762_963_578_4, 0.120_976_802_028_842_37),
        ([1.0, 1.0], 1.007_006_348_356_019, 0.069_975_044_789_025_64),
        ([0.25, 1.0 / 3.0], 1.011_076_387_159_194, 0.109_177_051_541_376_47),
    ];
    for ([x, y], first, second) in reference {
        let at = [2.0 * x - 1.0, 2.0 * y - 1.0];
        assert_close(radiosity(&plates, 0, at), first, 1e-6);
        assert_close(radiosity(&plates, 1, at), second, 1e-5);
    }
}

#[test]
fn coaxial_disks_have_the_radiosity_of_the_reference() {
    let disks = solved(
        "[materials.warm]\nreflectance = 0.5\nemission = 1\n[materials.cold]\nreflectance = 0.8
         [[surfaces]]\nmaterial = 'warm'\ndisk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }
         [[surfaces]]\nmaterial = 'cold'\ndisk = { center = [0, 0, 1], normal = [0, 0, -1], radius = 1 }",
        9,
        1e-8,
    );
    let reference = [
        (0.0, 1.087_019_715_346_179, 0.427_571_610_132_654),
        (0.25, 1.083_735_825_796_408_7, 0.414_016_160_686_808_8),
        (0.5, 1.074_363_380_852_882_5, 0.373_879_936_523_440_3),
        (0.75, 1.060_481_337_343_447_2, 0.310_759_963_724_044_6),
        (1.0, 1.044_878_249_226_698_6, 0.235_223_548_052_253_98),
    ];
    for (radius, first, second) in reference {
        let at = [0.3, 1.0 - 2.0 * radius];
        assert_close(radiosity(&disks, 0, at), first, 1e-5);
        assert_close(radiosity(&disks, 1, at), second, 1e-4);
    }
}
