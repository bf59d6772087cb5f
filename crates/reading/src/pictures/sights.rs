//! Sights: one surface or several that a camera sees in each pixel, and whether an emitter is among them.

use radiosity_geom::Encounter;
use radiosity_scene::{Camera, Scene};
use radiosity_visibility::Visibility;
use radiosity_work::ranks::{PartName, Ranks};
use serde::{Deserialize, Serialize};

use super::pinhole::Pinhole;

/// Surfaces and emitters seen through the pixels of a picture, in row order.
#[derive(Clone, Debug)]
pub struct Sights {
    /// The surface that is seen all over a pixel, if it is one and does not emit.
    parts: Vec<Option<u32>>,
    /// Whether an emitter is seen in a pixel.
    emitters: Vec<bool>,
}

/// Surface and emitter seen through one pixel.
#[derive(Serialize, Deserialize)]
struct Sight {
    part: Option<u32>,
    emitter: bool,
}

impl Sights {
    /// The sights of `camera` by `samples × samples` rays a pixel.
    pub fn through(
        camera: &Camera,
        samples: u32,
        scene: &Scene,
        visibility: &Visibility,
        ranks: &Ranks,
    ) -> Self {
        let view = Pinhole::new(camera);
        let count = camera.width as usize * camera.height as usize;
        let sights = ranks.map_even(PartName::Sights, count, camera.width as usize, |index| {
            let pixel = [index as u32 % camera.width, index as u32 / camera.width];
            sight(
                view.rays(pixel, samples).map(|ray| {
                    let seen = visibility.nearest(&ray);
                    seen.filter(|seen| seen.front).map(|Encounter { surface, .. }| surface)
                }),
                scene,
            )
        });
        let (parts, emitters) = sights.into_iter().map(|sight| (sight.part, sight.emitter)).unzip();
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

/// The sight of a pixel through which rays meet the fronts of `surfaces`.
fn sight(surfaces: impl Iterator<Item = Option<usize>>, scene: &Scene) -> Sight {
    let emits = |surface: &usize| scene.surfaces[*surface].material.emits();
    let surfaces: Vec<Option<usize>> = surfaces.collect();
    let emitter = surfaces.iter().flatten().any(emits);
    let one = surfaces.first().copied().flatten().filter(|_| surfaces.windows(2).all(|two| two[0] == two[1]));
    Sight { part: one.filter(|_| !emitter).and_then(|surface| u32::try_from(surface).ok()), emitter }
}
