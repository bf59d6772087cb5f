//! Pictures by light that is computed at few pixels and fitted between, against light computed at every
//! pixel.

use std::f64::consts::PI;

use radiosity::Work;
use radiosity::geom::{DVec3, Encounter, Ray};
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Camera;
use radiosity::solve::Options;
use radiosity::solve::solution::{Solution, SurfacePlace};
use radiosity::visibility::Visibility;
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::outcome_of;

/// Pixels across and down.
const SIZE: usize = 256;

/// One of so many pixels is compared: no divisor of [`SIZE`], and gathering takes some milliseconds for each.
const COMPARED: usize = 171;

/// A place that a pixel sees, with what is read there.
struct ReadPlace {
    element: usize,
    place: SurfacePlace,
    irradiance: Vec<f64>,
}

/// Irradiance at the front that a ray meets first.
fn read_along(ray: &Ray, visibility: &Visibility, solution: &Solution, reader: &Reader) -> Option<ReadPlace> {
    let Encounter { surface, hit, front: true, .. } = visibility.nearest(ray)? else { return None };
    let elements = solution.elements();
    let element = elements.at(surface, [hit.u, hit.v]).expect("no holes");
    let jet = elements.shape(surface).jet(hit.u, hit.v);
    let place = SurfacePlace { surface, parameters: [hit.u, hit.v], position: jet.position };
    let irradiance = reader.irradiance(element, &place, jet.normal).irradiance;
    Some(ReadPlace { element, place, irradiance })
}

#[test]
fn fitted_light_is_that_of_every_pixel() {
    for name in ["cornell-box", "two-boxes"] {
        let scene = builtin(name);
        let options = Options { order: 2, ..Options::default() };
        let outcome = outcome_of(&scene, &options);
        let visibility = options.visibility(&scene);
        let camera =
            Camera { width: SIZE as u32, height: SIZE as u32, ..scene.camera.clone().expect("a camera") };
        let raster = PictureRequest {
            solution: &outcome.solution,
            visibility: &visibility,
            camera: &camera,
            samples: 1,
            read: ReadMode::Gather,
            shown: Quantity::Radiosity,
            is_preview: false,
        }
        .picture(&Work::alone());
        let reader = Reader::new(&outcome.solution, &visibility, ReadMode::Gather, 1e-3);
        let view = Pinhole::new(&camera);
        let (mut squares, mut sum) = (0.0, 0.0);
        for (index, values) in raster.pixels().enumerate().step_by(COMPARED) {
            let ray = view.ray((index % SIZE) as f64 + 0.5, (index / SIZE) as f64 + 0.5);
            let Some(ReadPlace { element, place, irradiance }) =
                read_along(&ray, &visibility, &outcome.solution, &reader)
            else {
                continue;
            };
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

/// A pole two pixels thick throws a shadow as narrow on the floor, between the pixels of the grid at which direct light
/// is computed first: few pixels of it differ from what is read there.
#[test]
fn narrow_shadows_are_seen_between_the_pixels_of_the_grid() {
    let text = "bands = [\"lm\"]\n[materials.black]\nreflectance = 0\n[materials.lamp]\nreflectance = 0\nemission = 1000\n\
        [[surfaces]]\nmaterial = \"black\"\nparallelogram = { origin = [-3, -3, 0], edge1 = [6, 0, 0], edge2 = [0, 6, 0] }\n\
        [[surfaces]]\nmaterial = \"lamp\"\nsphere = { center = [0, 0, 3], radius = 0.1 }\n\
        [[surfaces]]\nmaterial = \"black\"\nbox = { origin = [1, 0.3, 0], size = [0.06, 0.06, 1.2] }\n";
    let scene = typed(text);
    let options = Options::default();
    let outcome = outcome_of(&scene, &options);
    let visibility = options.visibility(&scene);
    let size = 128;
    let eye = DVec3::new(0.0, -0.01, 6.0);
    let camera = Camera {
        width: size as u32,
        height: size as u32,
        up: DVec3::Y,
        fov: 40.0,
        ..Camera::new(eye, DVec3::new(0.8, 0.25, 0.0))
    };
    let (read, shown) = (ReadMode::Direct, Quantity::Irradiance);
    let raster = PictureRequest {
        solution: &outcome.solution,
        visibility: &visibility,
        camera: &camera,
        samples: 1,
        read,
        shown,
        is_preview: false,
    }
    .picture(&Work::alone());
    let reader = Reader::new(&outcome.solution, &visibility, read, 1e-3);
    let view = Pinhole::new(&camera);
    let (mut shadowed, mut off) = (0, 0);
    for (index, value) in raster.pixels().enumerate() {
        let ray = view.ray((index % size) as f64 + 0.5, (index / size) as f64 + 0.5);
        let found = read_along(&ray, &visibility, &outcome.solution, &reader);
        let Some(ReadPlace { place, irradiance, .. }) = found.filter(|found| found.place.surface == 0) else {
            continue;
        };
        let exact = irradiance[0];
        let distance = place.position.distance(DVec3::new(0.0, 0.0, 3.0));
        let unshadowed = 1000.0 * 0.1_f64.powi(2) * 3.0 / distance.powi(3);
        shadowed += u32::from(exact < 0.7 * unshadowed);
        off += u32::from((value[0] - exact).abs() > 0.05 * unshadowed);
    }
    assert!(shadowed > 50 && 20 * off < shadowed, "{off} of {shadowed} in shadow");
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
            let raster = PictureRequest {
                solution: &outcome.solution,
                visibility: &visibility,
                camera: &camera,
                samples: 1,
                read: ReadMode::Gather,
                shown,
                is_preview: false,
            }
            .picture(&Work::alone());
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
        let raster = PictureRequest {
            solution: &outcome.solution,
            visibility: &visibility,
            camera: &camera,
            samples: 1,
            read: ReadMode::Gather,
            shown: Quantity::Radiosity,
            is_preview: false,
        }
        .picture(&Work::alone());
        let found = raster.pixels().nth(4).expect("nine pixels")[0];
        let exact = 9.0 * 700.0 / 7.0 * (1.0 + 2.0 * height.sin()) / 3.0;
        assert!((found - exact).abs() < 1e-4 * exact, "{height}: {found}, not {exact}");
    }
}
