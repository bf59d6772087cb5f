//! The view that a page opens with, coarsely: what its exposure is chosen for.

use radiosity_geom::Encounter;
use rayon::prelude::*;

use super::start::Start;
use crate::output::lightmap::Lightmap;
use crate::output::pinhole::Pinhole;
use crate::output::raster::Raster;
use crate::output::shown::Shown;
use crate::scene::{Camera, Scene};
use crate::solved::Solved;

/// Most pixels along a side. Chosen.
const SIDE: u32 = 512;

/// The first view through the middles of its pixels, with the light of the textures at the factors of its groups.
pub(super) fn first_sight(solved: &Solved, lightmap: &Lightmap, start: &Start) -> Raster {
    let camera = smaller(&start.camera);
    let view = Pinhole::new(&camera);
    let bands = solved.scene.bands.len();
    let pixels: Vec<Option<Vec<f64>>> = (0..camera.width * camera.height)
        .into_par_iter()
        .map(|pixel| {
            let [x, y] = [pixel % camera.width, pixel / camera.width].map(|at| f64::from(at) + 0.5);
            let Encounter { surface, hit, front } = solved.visibility().nearest(&view.ray(x, y))?;
            front.then(|| shown(&solved.scene, lightmap, start.shown, surface, [hit.u, hit.v]))
        })
        .collect();
    let coverage = pixels.iter().map(|pixel| f64::from(u8::from(pixel.is_some()))).collect();
    let values = pixels.into_iter().flat_map(|pixel| pixel.unwrap_or_else(|| vec![0.0; bands])).collect();
    Raster::new([camera.width, camera.height], solved.scene.bands.clone(), values, coverage)
}

/// The camera with fewer pixels of the same shape.
fn smaller(camera: &Camera) -> Camera {
    let shrink = (f64::from(camera.width.max(camera.height)) / f64::from(SIDE)).max(1.0);
    let [width, height] = [camera.width, camera.height].map(|side| (f64::from(side) / shrink).ceil() as u32);
    Camera { width, height, ..camera.clone() }
}

/// The quantity per band at a place of a surface.
fn shown(scene: &Scene, lightmap: &Lightmap, shown: Shown, surface: usize, parameters: [f64; 2]) -> Vec<f64> {
    let (texture, own) = (&lightmap.surfaces()[surface], &scene.surfaces[surface]);
    let band = |band: usize| {
        let parts = lightmap.parts().iter().enumerate();
        let irradiance: f64 =
            parts.map(|(part, light)| light.factor * texture.at(part, band, parameters)).sum();
        match shown {
            Shown::Radiosity => own.exitance(band) + own.material.reflectance[band] * irradiance,
            Shown::Irradiance => irradiance,
        }
    };
    (0..scene.bands.len()).map(band).collect()
}
