//! Marks on a view: values at points, as disks over the scene in grey.
//!
//! Surfaces are as bright as the cosine c between a ray and their normal, ⅓ + ½ c, backs dark, all else white. A
//! disk has the colour of its value; points that the camera does not see have none.

use radiosity_geom::{DVec3, Ray};
use radiosity_reading::pictures::pinhole::Pinhole;
use radiosity_scene::{Camera, Scene};
use radiosity_visibility::Visibility;
use radiosity_work::ranks::{PartName, Ranks};

use crate::drawings::picture::{Colour, Picture};
use crate::drawings::scale::Scale;

/// Camera rays along each side of a pixel. Chosen.
const SAMPLES: u32 = 3;

/// Radius of a disk over the height of the picture, and of its rim (pixels). Chosen.
const RADIUS: f64 = 0.012;
const RIM: f64 = 1.5;

/// Radius of marks that count less, over that of the others. Chosen: half, a quarter of the area.
const LESSER: f64 = 0.5;

/// Part of the distance by which what is met may lie before a point that is seen. Chosen: far below a pixel.
const BEFORE: f64 = 1e-6;

const INK: Colour = [0; 3];

/// A value at a point.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    /// The point, in the coordinates that the scene is computed in.
    pub position: DVec3,
    /// Its value.
    pub value: f64,
    /// Whether it is drawn large; others have half the radius.
    pub is_large: bool,
}

/// A picture with marks, and how many of them there are in it.
#[derive(Clone, Debug)]
pub struct MarkedPicture {
    /// The picture.
    pub picture: Picture,
    /// Marks whose points the camera sees.
    pub seen: usize,
}

impl MarkedPicture {
    /// The scene in grey through `camera`, with marks coloured by `scale`, the larger values above the others.
    pub fn of(
        scene: &Scene,
        visibility: &Visibility,
        camera: &Camera,
        marks: &[Mark],
        scale: &Scale,
        ranks: &Ranks,
    ) -> Self {
        let view = Pinhole::new(camera);
        let mut picture = grey(scene, visibility, camera, &view, ranks);
        let mut order: Vec<&Mark> = marks.iter().collect();
        order.sort_by(|a, b| a.value.abs().total_cmp(&b.value.abs()));
        let mut seen = 0;
        for mark in order {
            if let Some(place) = place(visibility, camera, &view, mark.position) {
                let factor = if mark.is_large { 1.0 } else { LESSER };
                let radius = (factor * RADIUS * f64::from(camera.height)).max(2.0);
                picture.disk(place, radius + RIM, INK);
                picture.disk(place, radius, scale.colour(mark.value));
                seen += 1;
            }
        }
        Self { picture, seen }
    }
}

/// Where in the picture a point is seen (pixels), if it is.
fn place(visibility: &Visibility, camera: &Camera, view: &Pinhole, point: DVec3) -> Option<[f64; 2]> {
    let place @ [x, y] = view.place(point)?;
    let is_inside =
        (0.0..f64::from(camera.width)).contains(&x) && (0.0..f64::from(camera.height)).contains(&y);
    let towards = Ray { origin: camera.eye, direction: point - camera.eye, range: [0.0, 1.0 - BEFORE] };
    (is_inside && visibility.nearest(&towards).is_none()).then_some(place)
}

/// The scene in grey.
fn grey(scene: &Scene, visibility: &Visibility, camera: &Camera, view: &Pinhole, ranks: &Ranks) -> Picture {
    let [width, height] = [camera.width, camera.height].map(|pixels| pixels as usize);
    let codes: Vec<u8> = ranks.map_even(PartName::Sights, width * height, width, |index| {
        let pixel = [index % width, index / width].map(|at| at as u32);
        let sum: f64 = view.rays(pixel, SAMPLES).map(|ray| brightness(scene, visibility, &ray)).sum();
        (255.0 * sum / f64::from(SAMPLES * SAMPLES)).round() as u8
    });
    Picture::new(camera.width, camera.height, codes.into_iter().map(|code| [code; 3]).collect())
}

/// Brightness of what a ray meets, from 0 to 1.
fn brightness(scene: &Scene, visibility: &Visibility, ray: &Ray) -> f64 {
    match visibility.nearest(ray) {
        None => 1.0,
        Some(met) if !met.front => 0.2,
        Some(met) => {
            let jet = scene.surfaces[met.surface].shape.jet(met.hit.u, met.hit.v);
            1.0 / 3.0 + 0.5 * jet.normal.dot(ray.direction.normalize()).abs()
        }
    }
}
