//! Pictures by light that is computed at few pixels and fitted between, against light computed at every
//! pixel.

use std::f64::consts::PI;

use radiosity::Work;
use radiosity::geom::{DVec3, Encounter};
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::render::render;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Camera;
use radiosity::solve::Options;
use radiosity::solve::solution::SurfacePlace;
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::outcome_of;

/// Pixels across and down.
const SIZE: usize = 256;

/// One of so many pixels is compared: no divisor of [`SIZE`], and gathering takes a millisecond for each.
const COMPARED: usize = 11;

#[test]
fn fitted_light_is_that_of_every_pixel() {
    for name in ["cornell-box", "two-boxes"] {
        let scene = builtin(name);
        let options = Options { order: 2, ..Options::default() };
        let outcome = outcome_of(&scene, &options);
        let visibility = options.visibility(&scene);
        let camera =
            Camera { width: SIZE as u32, height: SIZE as u32, ..scene.camera.clone().expect("a camera") };
        let raster = render(
            &outcome.solution,
            &visibility,
            &camera,
            1,
            ReadMode::Gather,
            Quantity::Radiosity,
            &Work::alone(),
        );
        let reader = Reader::new(&outcome.solution, &visibility, ReadMode::Gather, 1e-3);
        let view = Pinhole::new(&camera);
        let (mut squares, mut sum) = (0.0, 0.0);
        for (index, values) in raster.pixels().enumerate().step_by(COMPARED) {
            let ray = view.ray((index % SIZE) as f64 + 0.5, (index / SIZE) as f64 + 0.5);
            let Some(Encounter { surface, hit, front: true }) = visibility.nearest(&ray) else { continue };
            let elements = outcome.solution.elements();
            let element = elements.at(surface, [hit.u, hit.v]).expect("no holes");
            let jet = elements.shape(surface).jet(hit.u, hit.v);
            let place = SurfacePlace { surface, parameters: [hit.u, hit.v], position: jet.position };
            let irradiance = reader.irradiance(element, &place, jet.normal).irradiance;
            for ((value, e), band) in values.iter().zip(irradiance).zip(outcome.solution.bands()) {
                let exact = band.coating.radiosity(element, place.parameters, e, 0.0);
                // Lamps are bright enough to hide all else.
                if band.coating.exitance[element] == 0.0 {
                    squares += (value - exact).powi(2);
                    sum += exact * exact;
                }
            }
        }
        let rms = (squares / sum).sqrt();
        // Readings in doubtful places are rays' own, to 7e-3.
        assert!(rms < 8e-3, "{name}: {rms}");
    }
}

/// The middle of a picture, in which an area sends I₀ cosⁿ γ, has the radiosity π L = π I₀ cosⁿ⁻¹ γ / A from
/// where it is seen.
#[test]
fn luminous_areas_are_as_bright_as_they_are_towards_the_eye() {
    let text = "bands = [\"lm\"]\n[materials.black]\nreflectance = 0\n[[surfaces]]\nmaterial = \"black\"\n\
        sphere = { center = [0, 0, -9], radius = 1 }\n[[luminaires]]\nposition = [0, 0, 2]\nspot = { exponent = 3 }\n\
        intensity = 10\nextent = [0.5, 0.8]\n";
    let scene = typed(text);
    let options = Options::default();
    let outcome = outcome_of(&scene, &options);
    let visibility = options.visibility(&scene);
    for gamma in [0.0_f64, 30.0, 60.0, 85.0].map(f64::to_radians) {
        let eye = DVec3::new(gamma.sin(), 0.0, 2.0 - gamma.cos());
        let camera =
            Camera { width: 3, height: 3, up: DVec3::Y, fov: 1.0, ..Camera::new(eye, 2.0 * DVec3::Z) };
        let shot = |shown: Quantity| {
            let raster =
                render(&outcome.solution, &visibility, &camera, 1, ReadMode::Gather, shown, &Work::alone());
            raster.pixels().nth(4).expect("nine pixels")[0]
        };
        let (found, exact) = (shot(Quantity::Radiosity), PI * 10.0 * gamma.cos().powi(2) / 0.4);
        assert!((found - exact).abs() < 1e-9 * exact, "{gamma}: {found}, not {exact}");
        assert_eq!(shot(Quantity::Irradiance), 0.0);
    }
}

/// So are openings to a sky: π L, with L = L_z (1 + 2 sin γ)/3 and L_z = 9 E/(7π) of the overcast sky.
#[test]
fn openings_are_as_bright_as_the_sky_behind_them() {
    let text = "bands = [\"lm\"]\n[sky]\nmodel = \"overcast\"\nilluminance = 700\n[materials.air]\nreflectance = 0\n[[surfaces]]\n\
        material = \"air\"\nopening = true\nparallelogram = { origin = [-1, -1, 3], edge1 = [0, 2, 0], edge2 = [2, 0, 0] }\n";
    let scene = typed(text);
    let options = Options::default();
    let outcome = outcome_of(&scene, &options);
    let visibility = options.visibility(&scene);
    for height in [90.0_f64, 45.0, 10.0].map(f64::to_radians) {
        let eye = DVec3::new(0.2 + height.cos(), 0.1, 3.0 - height.sin());
        let target = DVec3::new(0.2, 0.1, 3.0);
        let camera = Camera { width: 3, height: 3, up: DVec3::Y, fov: 1.0, ..Camera::new(eye, target) };
        let raster = render(
            &outcome.solution,
            &visibility,
            &camera,
            1,
            ReadMode::Gather,
            Quantity::Radiosity,
            &Work::alone(),
        );
        let found = raster.pixels().nth(4).expect("nine pixels")[0];
        let exact = 9.0 * 700.0 / 7.0 * (1.0 + 2.0 * height.sin()) / 3.0;
        assert!((found - exact).abs() < 1e-4 * exact, "{height}: {found}, not {exact}");
    }
}
