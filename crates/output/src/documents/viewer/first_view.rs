//! The view that a page opens with, by the light of its textures. The exposure of the page is chosen for it.
//!
//! Pixels average samples where they or a neighbour see another surface, as those of pictures do: where a
//! lamp fills about a fiftieth of the view, its borders decide on the exposure.

use radiosity_geom::Encounter;
use radiosity_scene::Camera;
use radiosity_solve::solved::Solved;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use super::first_view_settings::FirstViewSettings;
use radiosity_reading::pictures::lightmap::Lightmap;
use radiosity_reading::pictures::pinhole::Pinhole;
use radiosity_reading::pictures::raster::Raster;
use radiosity_reading::quantity::Quantity;

/// Most pixels along a side. Chosen.
const SIDE: u32 = 1024;

/// The first view, at the factors of its groups.
pub(super) fn first_view(solved: &Solved, lightmap: &Lightmap, start: &FirstViewSettings) -> Raster {
    let camera = smaller(&start.camera);
    let first_view = FirstView { solved, lightmap, shown: start.shown, view: Pinhole::new(&camera) };
    let size = [camera.width, camera.height];
    let [count, width] = [camera.width * camera.height, camera.width].map(|number| number as usize);
    let all = || (0..count).into_par_iter().with_min_len(width);
    let middle = |pixel: usize| {
        check_interrupt();
        Some(first_view.meet(place(size, pixel as u32, [0.5; 2]))?.0)
    };
    let middles: Vec<Option<usize>> = all().map(middle).collect();
    let pixels = all().map(|pixel| {
        check_interrupt();
        let samples = if is_inside(&middles, size, pixel as u32) { 1 } else { start.samples };
        first_view.mean(size, pixel as u32, samples)
    });
    let (values, coverage): (Vec<Vec<f64>>, Vec<f64>) = pixels.unzip();
    Raster::new(size, solved.scene.bands.clone(), values.concat(), coverage)
}

/// The camera with fewer pixels of the same shape.
fn smaller(camera: &Camera) -> Camera {
    let shrink = (f64::from(camera.width.max(camera.height)) / f64::from(SIDE)).max(1.0);
    let [width, height] = [camera.width, camera.height].map(|side| (f64::from(side) / shrink).ceil() as u32);
    Camera { width, height, ..camera.clone() }
}

/// The point at the part `at` of a pixel, in pixels from the upper left corner.
fn place([width, _]: [u32; 2], pixel: u32, at: [f64; 2]) -> [f64; 2] {
    [f64::from(pixel % width) + at[0], f64::from(pixel / width) + at[1]]
}

/// Whether the middles of a pixel and of all beside it see one surface.
fn is_inside(middles: &[Option<usize>], [width, height]: [u32; 2], pixel: u32) -> bool {
    let [column, row] = [pixel % width, pixel / width];
    let rows = row.saturating_sub(1)..=(row + 1).min(height - 1);
    let mut beside = rows.flat_map(|row| {
        (column.saturating_sub(1)..=(column + 1).min(width - 1)).map(move |column| row * width + column)
    });
    beside.all(|other| middles[other as usize] == middles[pixel as usize])
}

struct FirstView<'a> {
    solved: &'a Solved,
    lightmap: &'a Lightmap,
    shown: Quantity,
    view: Pinhole,
}

impl FirstView<'_> {
    /// The surface, and the parameters on it, whose front is met through a point of the picture.
    fn meet(&self, [x, y]: [f64; 2]) -> Option<(usize, [f64; 2])> {
        let Encounter { surface, hit, front } = self.solved.visibility().nearest(&self.view.ray(x, y))?;
        front.then_some((surface, [hit.u, hit.v]))
    }

    /// The mean quantity per band of a pixel by `samples × samples` rays, and the part of them that meet a
    /// front.
    fn mean(&self, size: [u32; 2], pixel: u32, samples: u32) -> (Vec<f64>, f64) {
        let part = |k: u32| (f64::from(k) + 0.5) / f64::from(samples);
        let share = 1.0 / f64::from(samples * samples);
        let (mut values, mut coverage) = (vec![0.0; self.solved.scene.bands.len()], 0.0);
        for k in 0..samples * samples {
            let at = place(size, pixel, [part(k % samples), part(k / samples)]);
            let Some((surface, parameters)) = self.meet(at) else { continue };
            coverage += share;
            for (band, sum) in values.iter_mut().enumerate() {
                *sum += share * self.value(band, surface, parameters);
            }
        }
        (values, coverage)
    }

    /// The quantity in a band at a place of a surface.
    fn value(&self, band: usize, surface: usize, parameters: [f64; 2]) -> f64 {
        let irradiance = self.lightmap.irradiance(surface, band, parameters);
        match self.shown {
            Quantity::Radiosity => {
                self.lightmap.radiosity(&self.solved.scene, surface, band, parameters, irradiance)
            }
            Quantity::Irradiance => irradiance,
        }
    }
}
