//! One place has one light, whatever shows it: a cell of a grid, sensors on it, and the pixels that see it.

use radiosity::Work;
use radiosity::elements::Elements;
use radiosity::geom::Encounter;
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::probe::{Probe, probe};
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::{Camera, Scene};
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::visibility::Visibility;
use radiosity_test_support::scenes::builtin;

use super::by_rays::solved;

/// Cells along each side of a surface, pixels across and down, and sensors along each side of a cell.
const CELLS: usize = 4;
const SIZE: u32 = 200;
const SENSORS: usize = 4;

/// One of so many cells is compared.
const EVERY: usize = 13;

/// Relative accuracy of what is read.
const EPS: f64 = 4e-3;

/// Differences that are no errors of gathered light, over it and the mean light: means over pixels, and by a few
/// sensors, of light with shadows' edges in it.
const BY_PIXELS: f64 = 0.015;
const BY_SENSORS: f64 = 0.02;

/// The mean light of each cell by the pixels that see it, weighted by the areas that they see, and these areas' sum,
/// surface by surface and u by u.
fn by_pixels(
    raster: &Raster,
    camera: &Camera,
    visibility: &Visibility,
    elements: &Elements,
) -> Vec<[f64; 2]> {
    let view = Pinhole::new(camera);
    let mut sums = vec![[0.0; 2]; elements.surfaces() * CELLS * CELLS];
    for (index, value) in raster.pixels().enumerate() {
        let at = [index % SIZE as usize, index / SIZE as usize].map(|k| k as f64 + 0.5);
        let ray = view.ray(at[0], at[1]);
        let Some(Encounter { surface, hit, front: true, .. }) = visibility.nearest(&ray) else { continue };
        let shape = elements.shape(surface);
        let jet = shape.jet(hit.u, hit.v);
        let step = jet.position - ray.origin;
        let forward = (camera.target - camera.eye).normalize();
        // A pixel of the width w at the distance 1 sees the area w² (s·f)³/(−s·n), s the step, f forward.
        let area = step.dot(forward).powi(3) / -step.dot(jet.normal);
        let place = |x: f64| ((0.5 * (1.0 + x) * CELLS as f64) as usize).min(CELLS - 1);
        let cell = (surface * CELLS + place(hit.u)) * CELLS + place(hit.v);
        sums[cell][0] += area * value[0];
        sums[cell][1] += area;
    }
    let pixel = 2.0 * f64::tan(0.5 * camera.fov.to_radians()) / f64::from(SIZE);
    sums.into_iter().map(|[light, area]| [light / area, pixel * pixel * area]).collect()
}

/// The mean light of a cell by sensors that lie evenly on it.
fn by_sensors(reader: &Reader, elements: &Elements, scene: &Scene, cell: &Cell) -> f64 {
    let place = |index: usize, k: usize| {
        -1.0 + 2.0 * (index as f64 + (k as f64 + 0.5) / SENSORS as f64) / CELLS as f64
    };
    let sensor = |k: usize| {
        let [u, v] = [place(cell.index[0], k / SENSORS), place(cell.index[1], k % SENSORS)];
        let jet = elements.shape(cell.surface).jet(u, v);
        Probe { position: jet.position + scene.middle, normal: jet.normal }
    };
    let sensors: Vec<Probe> = (0..SENSORS * SENSORS).map(sensor).collect();
    let read = probe(reader, &sensors, scene.middle, &Work::alone()).expect("light is gathered");
    read.iter().map(|reading| reading.irradiance[0]).sum::<f64>() / read.len() as f64
}

#[test]
fn cells_sensors_and_pixels_show_the_same_light() {
    for (name, by) in [("cornell-box", GatherMethod::Rays), ("two-boxes", GatherMethod::Auto)] {
        let scene = builtin(name);
        let (outcome, visibility) = solved(&scene);
        let elements = outcome.solution.elements();
        let camera = Camera { width: SIZE, height: SIZE, ..scene.camera.clone().expect("a camera") };
        let (read, shown) = (ReadMode::Gather, Quantity::Irradiance);
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
        let pixels = by_pixels(&raster, &camera, &visibility, elements);
        let reader = Reader::by(by, &outcome.solution, &visibility, read, EPS);
        let cells = grid(&reader, [CELLS; 2], Rates::default(), &Work::alone());
        let mean = cells.iter().map(|cell| cell.irradiance[0]).sum::<f64>() / cells.len() as f64;
        let is_bare = |cell: &&Cell| cell.exposed > 0.999 * cell.area;
        let (mut seen, mut compared) = (0, 0);
        for (number, cell) in cells.iter().filter(is_bare).enumerate() {
            let light = cell.irradiance[0];
            let told = cell.uncertainty.deviation.map_or(EPS * light, |own| own.absolute);
            let allowed = |of: f64| 3.0 * told + of * light.max(mean);
            let [shown, area] = pixels[(cell.surface * CELLS + cell.index[0]) * CELLS + cell.index[1]];
            if (area / cell.area - 1.0).abs() < 0.05 {
                seen += 1;
                assert!((shown - light).abs() < allowed(BY_PIXELS), "{name}: {shown} {cell:?}");
            }
            if number.is_multiple_of(EVERY) {
                compared += 1;
                let read = by_sensors(&reader, elements, &scene, cell);
                assert!((read - light).abs() < allowed(BY_SENSORS), "{name}: {read} {cell:?}");
            }
        }
        assert!(seen > 10 && compared > 5, "{name}: {seen} {compared}");
    }
}
