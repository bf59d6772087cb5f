//! A view of surfaces by the light of their textures. Files that hold these are exposed for it.
//!
//! Pixels average samples where they or a neighbour see another surface, as those of pictures do: where a
//! lamp fills about a fiftieth of the view, its borders decide on the exposure.

use radiosity_geom::Encounter;
use radiosity_scene::Camera;
use radiosity_solve::solved::Solved;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use radiosity_reading::pictures::lightmap::Lightmap;
use radiosity_reading::pictures::pinhole::Pinhole;
use radiosity_reading::pictures::pixel_grid::PixelGrid;
use radiosity_reading::pictures::raster::Raster;
use radiosity_reading::quantity::Quantity;

/// Most pixels along a side. Chosen.
const SIDE: u32 = 1024;

/// A raster of what `camera` sees of the quantity `shown`, at the factors of light groups, by the points
/// of a grid over each pixel where surfaces end.
pub fn lightmap_view(
    solved: &Solved,
    lightmap: &Lightmap,
    camera: &Camera,
    grid: &PixelGrid,
    shown: Quantity,
) -> Raster {
    let camera = smaller(camera);
    let lightmap_view = LightmapView { solved, lightmap, shown, view: Pinhole::new(&camera) };
    let size = [camera.width, camera.height];
    let [count, width] = [camera.width * camera.height, camera.width].map(|number| number as usize);
    let all = || (0..count).into_par_iter().with_min_len(width);
    let middle = |pixel: usize| {
        check_interrupt();
        Some(lightmap_view.meet(place(size, pixel as u32, [0.5; 2]))?.0)
    };
    let middles: Vec<Option<usize>> = all().map(middle).collect();
    let middle_alone = PixelGrid::new(1);
    let pixels = all().map(|pixel| {
        check_interrupt();
        let grid = if is_inside(&middles, size, pixel as u32) { &middle_alone } else { grid };
        lightmap_view.mean(size, pixel as u32, grid)
    });
    let pixels: Vec<MeanPixel> = pixels.collect();
    let values = pixels.iter().flat_map(|pixel| &pixel.values).copied().collect();
    let coverage = pixels.iter().map(|pixel| pixel.coverage).collect();
    let emitters = pixels.iter().map(|pixel| pixel.emits).collect();
    Raster::new(size, solved.scene.bands.clone(), values, coverage).with_emitters(emitters)
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

struct LightmapView<'a> {
    solved: &'a Solved,
    lightmap: &'a Lightmap,
    shown: Quantity,
    view: Pinhole,
}

/// A pixel by several rays.
struct MeanPixel {
    /// Mean of the quantity per band.
    values: Vec<f64>,
    /// Part of the rays that meet a front.
    coverage: f64,
    /// Whether one of them meets something that emits.
    emits: bool,
}

impl LightmapView<'_> {
    /// The surface, and the parameters on it, whose front is met through a point of the picture.
    fn meet(&self, [x, y]: [f64; 2]) -> Option<(usize, [f64; 2])> {
        let Encounter { surface, hit, front, .. } = self.solved.visibility().nearest(&self.view.ray(x, y))?;
        front.then_some((surface, [hit.u, hit.v]))
    }

    /// The mean of a pixel by rays through the points of a grid.
    fn mean(&self, size: [u32; 2], pixel: u32, grid: &PixelGrid) -> MeanPixel {
        let share = 1.0 / grid.points().len() as f64;
        let bands = self.solved.scene.bands.len();
        let mut mean = MeanPixel { values: vec![0.0; bands], coverage: 0.0, emits: false };
        for point in grid.points() {
            let Some((surface, parameters)) = self.meet(place(size, pixel, *point)) else { continue };
            mean.coverage += share;
            for (band, sum) in mean.values.iter_mut().enumerate() {
                *sum += share * self.value(band, surface, parameters);
            }
            let scene_surface = &self.solved.scene.surfaces[surface];
            mean.emits |= (0..bands).any(|band| scene_surface.exitance(band) > 0.0);
        }
        mean
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
