//! Pictures by light that is computed at few pixels and fitted between, against light computed at every pixel.

use radiosity::geom::Encounter;
use radiosity::output::pinhole::Pinhole;
use radiosity::output::reader::{Read, Reader};
use radiosity::output::render::render;
use radiosity::output::shown::Shown;
use radiosity::scene::{Camera, Scene};
use radiosity::solution::Place;
use radiosity::solve::{Options, solve};
use radiosity::visibility::Visibility;

/// Pixels across and down.
const SIZE: usize = 256;

#[test]
fn fitted_light_is_that_of_every_pixel() {
    for name in ["cornell-box", "two-boxes"] {
        let scene = Scene::builtin(name).expect("built in");
        let options = Options { order: 2, ..Options::default() };
        let outcome = solve(&scene, &options, &|_| {}).expect("it is solved");
        let visibility = Visibility::new(&scene, (&options).into());
        let camera =
            Camera { width: SIZE as u32, height: SIZE as u32, ..scene.camera.clone().expect("a camera") };
        let raster =
            render(&outcome.solution, &visibility, &camera, 1, Read::Gather, Shown::Radiosity, &|_| {});
        let reader = Reader::new(&outcome.solution, &visibility, Read::Gather, 1e-3);
        let view = Pinhole::new(&camera);
        let (mut squares, mut sum) = (0.0, 0.0);
        for (index, values) in raster.pixels().enumerate() {
            let ray = view.ray((index % SIZE) as f64 + 0.5, (index / SIZE) as f64 + 0.5);
            let Some(Encounter { surface, hit, front: true }) = visibility.nearest(&ray) else { continue };
            let elements = outcome.solution.elements();
            let element = elements.at(surface, [hit.u, hit.v]).expect("no holes");
            let jet = elements.shape(surface).jet(hit.u, hit.v);
            let place = Place { surface, parameters: [hit.u, hit.v], position: jet.position };
            let irradiance = reader.irradiance(element, &place, jet.normal).irradiance;
            for ((value, e), band) in values.iter().zip(irradiance).zip(outcome.solution.bands()) {
                let exact = band.coating.radiosity(element, e);
                // Lamps are bright enough to hide all else.
                if band.coating.exitance[element] == 0.0 {
                    squares += (value - exact).powi(2);
                    sum += exact * exact;
                }
            }
        }
        let rms = (squares / sum).sqrt();
        assert!(rms < 5e-3, "{name}: {rms}");
    }
}
