//! Surfaces seen through pixels: one surface or several that a camera sees in each pixel, and whether an
//! emitter is among them.

use radiosity_geom::Encounter;
use radiosity_scene::{Camera, Scene};
use radiosity_visibility::Visibility;
use radiosity_work::ranks::{PartName, Ranks};
use serde::{Deserialize, Serialize};

use super::pinhole::Pinhole;
use super::pixel_grid::PixelGrid;

/// Surfaces and emitters seen through the pixels of a picture, in row order.
#[derive(Clone, Debug)]
pub struct SeenSurfaces {
    /// The surface that is seen all over a pixel, if it is one and does not emit.
    parts: Vec<Option<u32>>,
    /// Whether an emitter is seen in a pixel.
    emitters: Vec<bool>,
}

/// Surface and emitter seen through one pixel.
#[derive(Serialize, Deserialize)]
struct PixelSurface {
    part: Option<u32>,
    emitter: bool,
}

impl SeenSurfaces {
    /// The surfaces seen by `camera` through the points of a grid over each pixel.
    pub fn through(
        camera: &Camera,
        grid: &PixelGrid,
        scene: &Scene,
        visibility: &Visibility,
        ranks: &Ranks,
    ) -> Self {
        let view = Pinhole::new(camera);
        let count = camera.width as usize * camera.height as usize;
        let pixels = ranks.map_even(PartName::Sights, count, camera.width as usize, |index| {
            let pixel = [index as u32 % camera.width, index as u32 / camera.width];
            pixel_surface(
                view.rays(pixel, grid).map(|ray| {
                    let seen = visibility.nearest(&ray);
                    seen.filter(|seen| seen.front).map(|Encounter { surface, .. }| surface)
                }),
                scene,
            )
        });
        let (parts, emitters) = pixels.into_iter().map(|pixel| (pixel.part, pixel.emitter)).unzip();
        Self { parts, emitters }
    }

    /// The surface that is seen all over a pixel, if it is one and does not emit; in row order.
    pub fn parts(&self) -> &[Option<u32>] {
        &self.parts
    }

    /// Whether an emitter is seen in a pixel; in row order.
    pub fn emitters(&self) -> &[bool] {
        &self.emitters
    }
}

/// The surface of a pixel through which rays meet the fronts of `surfaces`.
fn pixel_surface(surfaces: impl Iterator<Item = Option<usize>>, scene: &Scene) -> PixelSurface {
    let emits = |surface: &usize| scene.surfaces[*surface].material.emits();
    let surfaces: Vec<Option<usize>> = surfaces.collect();
    let emitter = surfaces.iter().flatten().any(emits);
    let one = surfaces.first().copied().flatten().filter(|_| surfaces.windows(2).all(|two| two[0] == two[1]));
    PixelSurface { part: one.filter(|_| !emitter).and_then(|surface| u32::try_from(surface).ok()), emitter }
}
