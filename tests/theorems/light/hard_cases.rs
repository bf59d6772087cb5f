//! Scenes on which an earlier version was wrong, dark or slow.

use radiosity::Work;
use radiosity::reading::pictures::render::{PictureRequest, ReadMode};
use radiosity::reading::quantity::Quantity;
use radiosity::scene::Scene;
use radiosity::solve::{Options, Outcome};
use radiosity::visibility::Visibility;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

fn scene(surfaces: &str) -> Scene {
    let text = format!(
        "bands = [\"grey\"]\n[camera]\neye = [0.5, 0.5, 3]\ntarget = [0.5, 0.5, 0]\nup = [0, 1, 0]\nfov = 40\nwidth = 4\nheight = 4\n\
         [materials.white]\nreflectance = 0.8\n[materials.black]\nreflectance = 0\n\
         [materials.lamp]\nreflectance = 0\nemission = 1\n{surfaces}"
    );
    typed(&text)
}

fn quad(name: &str, material: &str, vertices: [[f64; 3]; 4]) -> String {
    format!(
        "[[surfaces]]\nname = \"{name}\"\nmaterial = \"{material}\"\nquad = {{ vertices = {vertices:?} }}\n"
    )
}

/// A horizontal square of half side `half` around (x, y) = (½, ½), its front up or down.
fn level(name: &str, material: &str, z: f64, half: f64, up: bool) -> String {
    let (a, b) = (0.5 - half, 0.5 + half);
    let mut vertices = [[a, a, z], [b, a, z], [b, b, z], [a, b, z]];
    if !up {
        vertices.reverse();
    }
    quad(name, material, vertices)
}

fn solved(scene: &Scene, eps: f64) -> Outcome {
    let options = Options { eps, subdivide: Some(1), threads: 2, ..Options::default() };
    outcome_of(scene, &options)
}

#[test]
fn a_plate_close_to_a_small_lamp_hides_it() {
    let plate = level("plate", "black", 2.99, 1.0, false) + "two_sided = true\n";
    let scene =
        scene(&(level("lamp", "lamp", 3.0, 0.01, false) + &plate + &level("floor", "white", 0.0, 2.0, true)));
    let outcome = solved(&scene, 1e-3);
    assert_eq!(outcome.solution.elements().list().len(), 4);
    let floor = scene.surfaces.iter().position(|surface| surface.name == "floor").expect("there is a floor");
    let start: usize = outcome.solution.elements().list()[..floor].iter().map(|e| e.basis.len()).sum();
    assert_eq!(outcome.solution.bands()[0].coefficients.irradiance[start], 0.0, "nothing passes the plate");
}

#[test]
fn slivers_left_by_clipping_cost_little() {
    for gap in [1e-2, 1e-4, 1e-6] {
        let x = 1.0 - gap;
        let floor = quad("floor", "lamp", [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let wall = quad("wall", "white", [[x, 0., 0.], [x, 1., 0.], [x, 1., 1.], [x, 0., 1.]]);
        let outcome = solved(&scene(&(floor + &wall)), 1e-3);
        assert!(outcome.samples < 20_000_000, "gap {gap}: {} samples", outcome.samples);
        // The wall sees the strip of floor before it at most.
        assert!(outcome.checks.row_sum_max <= gap, "gap {gap}: {:?}", outcome.checks);
    }
}

#[test]
fn narrow_hinges_keep_their_accuracy() {
    for degrees in [1.0f64, 5.0, 20.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let floor = quad("floor", "lamp", [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let lid = quad("lid", "white", [[0., 0., 0.], [0., cos, sin], [1., cos, sin], [1., 0., 0.]]);
        let scene = scene(&(floor + &lid));
        let [coarse, fine] = [1e-3, 1e-7].map(|eps| solved(&scene, eps).checks.row_sum_max);
        assert!(fine < 1.0, "{degrees}°: {fine}");
        assert!((coarse - fine).abs() <= 1e-3 * fine, "{degrees}°: {coarse} {fine}");
    }
}

#[test]
fn two_sided_panels_are_seen_from_both_sides() {
    for up in [true, false] {
        let panel = level("panel", "lamp", 0.0, 2.0, up) + "two_sided = true\n";
        let scene = scene(&panel);
        let outcome = solved(&scene, 1e-3);
        let camera = scene.camera.clone().expect("there is a camera");
        let visibility = Visibility::open(&scene);
        let image = PictureRequest {
            solution: &outcome.solution,
            visibility: &visibility,
            camera: &camera,
            samples: 1,
            read: ReadMode::Basis,
            shown: Quantity::Radiosity,
            is_preview: false,
        }
        .picture(&Work::alone());
        assert!(image.pixels().all(|pixel| *pixel == [1.0]), "the panel fills the picture");
    }
}

#[test]
fn sheared_parallelograms_keep_energy_at_high_order() {
    let floor = "[[surfaces]]\nname = \"floor\"\nmaterial = \"white\"\nparallelogram = { origin = [0,0,0], edge1 = [1,0,0], edge2 = [10,1,0] }\norder = 12\n";
    let lamp = level("lamp", "lamp", 2.0, 1.0, false);
    let outcome = solved(&scene(&(floor.to_owned() + &lamp)), 1e-3);
    let checks = outcome.checks;
    assert!(checks.spectral_bound < 0.8, "{checks:?}");
    assert!(checks.energy_absorbed > 0.0 && checks.energy_lost < checks.energy_in, "{checks:?}");
}
