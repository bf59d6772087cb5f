//! Means over surfaces, over parts of them, and through pixels, of the light of a point source or a spot:
//! quadrature over the same places in the test.

use std::sync::Arc;

use radiosity::audit::{Pixel, Spot};
use radiosity::scene::{Camera, Distribution, Luminaire, Material, Strength};
use radiosity::{Scene, SceneBuilder};
use radiosity_geom::{DVec3, Rect, Surface};
use radiosity_test_support::gallery::gallery;

use super::fairness::assert_fair;
use super::trial::{Trial, quotients};

const WALKS: f64 = 1024.0;

/// Midpoints along each parameter.
const SIDE: usize = 500;

/// A surface of this reflectance under a source of the intensity 1 in all directions.
fn lit(shape: Arc<dyn Surface>, reflectance: f64, source: DVec3) -> Scene {
    let mut builder = SceneBuilder::new("lit", ["grey"]);
    let grey = Material::new(vec![reflectance], vec![0.0]).expect("a reflectance");
    let grey = builder.material("grey", grey);
    builder.surface("surface", shape, &grey);
    let strength = Strength::Intensity(vec![1.0]);
    builder.luminaire(Luminaire::new("source", source, Distribution::Point, strength).expect("a luminaire"));
    builder.build().unwrap_or_else(|error| panic!("{error}"))
}

/// E = cos θ / r² at a place of a surface that does not hide itself.
fn irradiance(point: DVec3, normal: DVec3, source: DVec3) -> f64 {
    let step = source - point;
    normal.dot(step).max(0.0) / step.length().powi(3)
}

/// The mean over the part of a rectangle of parameters that belongs to the surface, by area.
fn mean(shape: &dyn Surface, rect: &Rect, source: DVec3) -> f64 {
    let at = |k: usize| (2.0 * k as f64 + 1.0) / SIDE as f64 - 1.0;
    let (mut sum, mut area) = (0.0, 0.0);
    for k in 0..SIDE * SIDE {
        let [u, v] = rect.at(at(k % SIDE), at(k / SIDE));
        let jet = shape.jet(u, v);
        if shape.region().is_none_or(|region| region.contains(jet.position)) {
            sum += jet.area * irradiance(jet.position, jet.normal, source);
            area += jet.area;
        }
    }
    sum / area
}

/// Exhibits that a source above their fronts sees whole, or that are convex.
const SEEN: [&str; 13] = [
    "parallelogram",
    "triangle",
    "polygon",
    "polygon with a hole",
    "planar quad",
    "disk",
    "ring sector",
    "cylinder",
    "cone",
    "sphere",
    "sphere zone",
    "trimmed",
    "rational sphere octant",
];

pub(super) fn cells() -> Vec<Trial> {
    let rects = [
        Rect::FULL,
        Rect { u: [-1.0, -0.2], v: [-0.4, 1.0] },
        Rect { u: [-0.1, 1.0], v: [-0.2, 1.0] },
        Rect { u: [-0.5, 0.7], v: [-1.0, 0.3] },
    ];
    let mut trials = Vec::new();
    for exhibit in gallery().into_iter().filter(|own| SEEN.contains(&own.name)) {
        let shape: Arc<dyn Surface> = Arc::from(exhibit.surface);
        let bounds = shape.bounds(&Rect::FULL);
        let middle = shape.jet(0.1, 0.2);
        let size = (bounds.max - bounds.min).length();
        let source = middle.position + size * (0.4 * middle.normal + 0.1 * DVec3::ONE);
        let mut trial = Trial::of(exhibit.name, lit(Arc::clone(&shape), 0.0, source));
        trial = trial.spot(Spot::Surface(0), &[mean(shape.as_ref(), &Rect::FULL, source)]);
        for rect in rects {
            trial = trial.spot(Spot::Cell { surface: 0, rect }, &[mean(shape.as_ref(), &rect, source)]);
        }
        trials.push(trial);
    }
    trials
}

#[test]
fn surfaces_and_cells_receive_their_means() {
    assert_fair(&quotients(&cells(), WALKS, 1200));
}

/// Through a pixel comes ρ E, by the mean over its area.
pub(super) fn pixels() -> Vec<Trial> {
    let source = DVec3::new(0.3, 0.2, 0.6);
    let corner = DVec3::new(-2.0, -2.0, 0.0);
    let shape = radiosity_test_support::shapes::wall(corner, 4.0 * DVec3::X, 4.0 * DVec3::Y);
    let scene = lit(shape, 0.6, source);
    let camera =
        Camera { width: 24, height: 16, fov: 40.0, ..Camera::new(DVec3::new(2.0, -1.0, 2.0), DVec3::ZERO) };
    let view = (camera.target - camera.eye).normalize();
    let right = view.cross(DVec3::Z).normalize();
    let up = right.cross(view);
    let side = 2.0 * 20.0_f64.to_radians().tan() / 16.0;
    let mut trial = Trial::of("pixels", scene);
    let seen =
        Camera { eye: camera.eye - trial.scene.middle, target: camera.target - trial.scene.middle, ..camera };
    for row in 3..13 {
        for column in 6..18 {
            const PARTS: usize = 30;
            let mut sum = 0.0;
            for k in 0..PARTS * PARTS {
                let [x, y] = [k % PARTS, k / PARTS].map(|own| (own as f64 + 0.5) / PARTS as f64);
                let [x, y] = [f64::from(column) + x - 12.0, 8.0 - f64::from(row) - y];
                let along = view + side * (x * right + y * up);
                let point = camera.eye - camera.eye.z / along.z * along;
                sum += 0.6 * irradiance(point, DVec3::Z, source);
            }
            trial = trial.spot(Spot::Pixel(Pixel::of(&seen, column, row)), &[sum / (PARTS * PARTS) as f64]);
        }
    }
    vec![trial]
}

#[test]
fn pixels_show_what_their_surface_reflects() {
    assert_fair(&quotients(&pixels(), 256.0, 1300));
}
