//! Direct light of surfaces: Lambert's form of polygons and disks, the ball, and quadrature over all other
//! shapes.
//!
//! A polygon of the exitance M with corners r_i, seen from the origin above its horizon, gives (J. H. Lambert,
//! *Photometria*, 1760)
//!
//! ```text
//! E = M/(2π) Σ_i θ_i n·(r_i × r_{i+1}) / |r_i × r_{i+1}| ,     θ_i the angle between r_i and r_{i+1}
//! ```

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use radiosity::scene::Material;
use radiosity::{Scene, SceneBuilder};
use radiosity_geom::{DVec3, Ray, Surface};
use radiosity_test_support::gallery::{Exhibit, gallery};
use radiosity_test_support::random::Random;
use radiosity_test_support::shapes::{ball, disk};

use super::fairness::assert_fair;
use super::trial::{Trial, quotients};

/// Exitance of the lamps.
pub(super) const EXITANCE: f64 = 700.0;

const WALKS: f64 = 1024.0;

/// A black lamp and nothing else.
fn lamp(shape: Arc<dyn Surface>) -> Scene {
    let mut builder = SceneBuilder::new("lamp", ["grey"]);
    let glow = Material::new(vec![0.0], vec![EXITANCE]).expect("a lamp");
    let glow = builder.material("glow", glow);
    builder.surface("lamp", shape, &glow);
    builder.build().unwrap_or_else(|error| panic!("{error}"))
}

/// Lambert's form: positive for corners that run clockwise seen from the point, as those of a lamp whose front
/// faces it do where the front is left of them.
pub(super) fn lambert(corners: &[DVec3], point: DVec3, normal: DVec3) -> f64 {
    let edge = |k: usize| {
        let [a, b] = [corners[k], corners[(k + 1) % corners.len()]].map(|own| own - point);
        let across = a.cross(b);
        across.length().atan2(a.dot(b)) * normal.dot(across) / across.length()
    };
    EXITANCE / TAU * (0..corners.len()).map(edge).sum::<f64>()
}

/// Points before the front of a surface and normals so that all of a ball around it is above their horizon.
fn sensors(center: DVec3, radius: f64, front: DVec3, count: usize, seed: u64) -> Vec<(DVec3, DVec3)> {
    let mut random = Random(seed);
    let mut found = Vec::new();
    while found.len() < count {
        let point = center + random.between(1.3, 4.0) * radius * random.direction();
        let normal = (center - point + random.between(0.0, 1.0) * radius * random.direction()).normalize();
        let is_before = front.dot(point - center) > 0.2 * radius;
        if is_before && normal.dot(center - point) > radius {
            found.push((point, normal));
        }
    }
    found
}

fn of_points(
    name: &str,
    scene: Scene,
    points: Vec<(DVec3, DVec3)>,
    exact: impl Fn(DVec3, DVec3) -> f64,
) -> Trial {
    points.into_iter().fold(Trial::of(name, scene), |trial, (x, n)| trial.point(x, n, exact(x, n)))
}

/// Flat exhibits by Lambert's form, holes taken off.
pub(super) fn polygons() -> Vec<Trial> {
    let trial = |(seed, Exhibit { name, surface, .. }): (u64, Exhibit)| {
        let region = surface.region()?;
        let (outer, holes, front) = (region.outer().to_vec(), region.holes().to_vec(), region.normal());
        let center = outer.iter().sum::<DVec3>() / outer.len() as f64;
        let radius = outer.iter().map(|own| own.distance(center)).fold(0.0, f64::max);
        let exact = move |x: DVec3, n: DVec3| {
            lambert(&outer, x, n).abs() - holes.iter().map(|own| lambert(own, x, n).abs()).sum::<f64>()
        };
        Some(of_points(name, lamp(Arc::from(surface)), sensors(center, radius, front, 16, seed), exact))
    };
    (0..).zip(gallery()).filter_map(trial).collect()
}

/// Disks as polygons of many sides, and above their middles by π M r²/(r² + h²).
pub(super) fn disks() -> Vec<Trial> {
    let (center, normal, radius) = (DVec3::new(0.3, 0.2, -0.1), DVec3::new(0.2, 0.4, 1.0).normalize(), 0.6);
    let (a, b) = normal.any_orthonormal_pair();
    let rim = |k: usize, radius: f64| {
        let (sine, cosine) = (TAU * k as f64 / 5000.0).sin_cos();
        center + radius * (cosine * a + sine * b)
    };
    let corners: Vec<DVec3> = (0..5000).map(|k| rim(k, radius)).collect();
    let exact = move |x: DVec3, n: DVec3| lambert(&corners, x, n).abs();
    let mut trial = of_points(
        "disk",
        lamp(Arc::new(disk(center, normal, radius))),
        sensors(center, radius, normal, 20, 5),
        exact,
    );
    for height in [1e-4, 0.01, 0.1, 0.5, 2.0, 30.0] {
        let right = EXITANCE * radius * radius / (radius * radius + height * height);
        trial = trial.point(center + height * normal, -normal, right);
    }
    vec![trial]
}

/// E = M (r/d)² cos θ.
pub(super) fn balls() -> Vec<Trial> {
    let (center, radius) = (DVec3::new(-0.4, 0.1, 0.2), 0.8);
    let exact = move |x: DVec3, n: DVec3| {
        let step = center - x;
        EXITANCE * radius * radius * n.dot(step) / step.length().powi(3)
    };
    let points = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::ONE];
    let points = points
        .into_iter()
        .zip(0..)
        .flat_map(|(front, seed)| sensors(center, radius, front, 10, seed))
        .collect();
    vec![of_points("ball", lamp(Arc::new(ball(center, radius))), points, exact)]
}

/// Irradiance by a curved lamp: midpoints of its parameters, each seen or not.
fn by_area(shape: &dyn Surface, point: DVec3, normal: DVec3) -> f64 {
    const SIDE: usize = 300;
    let at = |k: usize| -1.0 + (2.0 * k as f64 + 1.0) / SIDE as f64;
    let mut sum = 0.0;
    for k in 0..SIDE * SIDE {
        let jet = shape.jet(at(k % SIDE), at(k / SIDE));
        let step = jet.position - point;
        let squared = step.length_squared();
        let cosines = [normal.dot(step), -jet.normal.dot(step)];
        if cosines.iter().all(|own| *own > 0.0) {
            let ray = Ray::segment(point, point.lerp(jet.position, 1.0 - 1e-6));
            if shape.intersect(&ray).is_none() {
                sum += jet.area * cosines[0] * cosines[1] / (squared * squared);
            }
        }
    }
    EXITANCE / PI * sum * (2.0 / SIDE as f64).powi(2)
}

/// Curved exhibits, from all around.
fn curved() -> Vec<Trial> {
    let trial = |(seed, Exhibit { name, surface, .. }): (u64, Exhibit)| {
        if surface.region().is_some() {
            return None;
        }
        let shape: Arc<dyn Surface> = Arc::from(surface);
        let bounds = shape.bounds(&radiosity_geom::Rect::FULL);
        let (center, radius) = (bounds.center(), 0.5 * (bounds.max - bounds.min).length());
        let fronts = [DVec3::ONE, DVec3::new(-1.0, 1.0, -1.0), DVec3::new(0.0, -1.0, -0.3)];
        let points = fronts.into_iter().flat_map(|front| sensors(center, radius, front, 2, seed));
        let trial = Trial::of(name, lamp(Arc::clone(&shape)));
        Some(points.fold(trial, |trial, (x, n)| {
            let exact = by_area(shape.as_ref(), x, n);
            // A sliver that is seen at its edge is too small for the quadrature.
            if exact > 1e-3 * EXITANCE { trial.point(x, n, exact) } else { trial }
        }))
    };
    (0..).zip(gallery()).filter_map(trial).collect()
}

#[test]
fn polygons_give_lamberts_form() {
    assert_fair(&quotients(&polygons(), WALKS, 400));
}

#[test]
fn disks_and_balls_give_their_closed_forms() {
    let trials: Vec<Trial> = disks().into_iter().chain(balls()).collect();
    assert_fair(&quotients(&trials, WALKS, 500));
}

/// The quadrature is right to 2e-3 or so: few walks, whose errors are larger.
#[test]
fn curved_lamps_give_what_quadrature_gives() {
    assert_fair(&quotients(&curved(), 256.0, 600));
}
