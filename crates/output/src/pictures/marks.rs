//! Marks on a view: values at points, as disks over the scene in grey.
//!
//! Surfaces are as bright as the cosine c between a ray and their normal, ⅓ + ½ c, backs dark, all else white. A
//! disk has the colour of its value; points that something hides are rings.

use std::f64::consts::TAU;

use radiosity_geom::{DVec3, Ray};
use radiosity_reading::pictures::pinhole::Pinhole;
use radiosity_reading::pictures::pixel_grid::PixelGrid;
use radiosity_scene::{Camera, Scene};
use radiosity_visibility::Visibility;
use radiosity_work::ranks::{PartName, Ranks};

use crate::drawings::picture::{Colour, Picture};
use crate::drawings::scale::Scale;
use crate::drawings::stroke::Stroke;

/// Camera rays about along each side of a pixel. Chosen.
const SAMPLES: u32 = 3;

/// Radius of a disk over the height of the picture. Chosen.
const RADIUS: f64 = 0.016;

/// Least radius, breadth of the rim and breadth of a ring (pixels). Chosen.
const LEAST: f64 = 2.0;
const RIM: f64 = 1.0;
const RING: f64 = 2.0;

/// Corners of a ring.
const CORNERS: usize = 48;

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
    /// Marks in it whose points the camera sees.
    pub seen: usize,
    /// Marks in it whose points something hides.
    pub hidden: usize,
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
        let is_seen = |mark: &&Mark| {
            let direction = mark.position - camera.eye;
            let towards = Ray { origin: camera.eye, direction, range: [0.0, 1.0 - BEFORE] };
            visibility.nearest(&towards).is_none()
        };
        let (seen, hidden): (Vec<&Mark>, Vec<&Mark>) = order.into_iter().partition(is_seen);
        let mut drawn = [0; 2];
        for (kind, marks) in [hidden, seen].into_iter().enumerate() {
            for mark in marks {
                let Some(place) = place(camera, &view, mark.position) else { continue };
                let factor = if mark.is_large { 1.0 } else { LESSER };
                let radius = (factor * RADIUS * f64::from(camera.height)).max(LEAST);
                let draw = [ring, disk][kind];
                draw(&mut picture, place, radius, scale.colour(mark.value));
                drawn[kind] += 1;
            }
        }
        let [hidden, seen] = drawn;
        Self { picture, seen, hidden }
    }
}

/// The place of a point in the picture (pixels), if it is in it.
fn place(camera: &Camera, view: &Pinhole, point: DVec3) -> Option<[f64; 2]> {
    let place @ [x, y] = view.place(point)?;
    let is_inside =
        (0.0..f64::from(camera.width)).contains(&x) && (0.0..f64::from(camera.height)).contains(&y);
    is_inside.then_some(place)
}

fn disk(picture: &mut Picture, place: [f64; 2], radius: f64, colour: Colour) {
    picture.disk(place, radius + RIM, INK);
    picture.disk(place, radius, colour);
}

fn ring(picture: &mut Picture, place: [f64; 2], radius: f64, colour: Colour) {
    let corner = |k: usize| {
        let (sine, cosine) = (TAU * k as f64 / CORNERS as f64).sin_cos();
        [place[0] + radius * cosine, place[1] + radius * sine]
    };
    let around: Vec<[f64; 2]> = (0..=CORNERS).map(corner).collect();
    for (breadth, colour) in [(RING + 2.0 * RIM, INK), (RING, colour)] {
        let mut stroke = Stroke::new(picture.size());
        stroke.line(&around, breadth);
        stroke.draw(picture, colour, 1.0);
    }
}

/// The scene in grey.
fn grey(scene: &Scene, visibility: &Visibility, camera: &Camera, view: &Pinhole, ranks: &Ranks) -> Picture {
    let [width, height] = [camera.width, camera.height].map(|pixels| pixels as usize);
    let grid = PixelGrid::new(SAMPLES);
    let codes: Vec<u8> = ranks.map_even(PartName::Sights, width * height, width, |index| {
        let pixel = [index % width, index / width].map(|at| at as u32);
        let sum: f64 = view.rays(pixel, &grid).map(|ray| brightness(scene, visibility, &ray)).sum();
        (255.0 * sum / grid.points().len() as f64).round() as u8
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
