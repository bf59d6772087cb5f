//! Surfaces that tests write again and again, all of them valid.

use std::sync::Arc;

use radiosity_geom::shapes::{Cylinder, Disk, FULL_TURN, Parallelogram, Sphere};
use radiosity_geom::{DVec3, Flipped, Surface};

/// A whole sphere, its front outside.
pub fn ball(center: DVec3, radius: f64) -> Sphere {
    Sphere::new(center, radius, DVec3::Z, [-radius, radius], FULL_TURN).expect("a radius above 0")
}

/// A whole disk without a hole.
pub fn disk(center: DVec3, normal: DVec3, radius: f64) -> Disk {
    Disk::new(center, normal, radius, 0.0, FULL_TURN).expect("a radius and a normal above 0")
}

/// A whole cylinder without its ends, its front outside.
pub fn tube(base: DVec3, axis: DVec3, radius: f64) -> Cylinder {
    Cylinder::new(base, axis, radius, FULL_TURN).expect("a radius and an axis above 0")
}

/// A parallelogram with its front along `edge1` × `edge2`.
pub fn plate(origin: DVec3, edge1: DVec3, edge2: DVec3) -> Parallelogram {
    Parallelogram::new(origin, edge1, edge2).expect("edges that are not parallel")
}

/// A [`plate`] that can be shared.
pub fn wall(origin: DVec3, edge1: DVec3, edge2: DVec3) -> Arc<dyn Surface> {
    Arc::new(plate(origin, edge1, edge2))
}

/// A surface with its front on the other side.
pub fn inside(surface: impl Surface + 'static) -> Arc<dyn Surface> {
    Arc::new(Flipped::new(Box::new(surface)))
}

/// The faces of a box with a corner at `corner`, fronts along the edges' cross products: inside where the
/// edges are right-handed. For each edge in turn the face at the corner and the one across.
pub fn faces(corner: DVec3, edges: [DVec3; 3]) -> [Parallelogram; 6] {
    let face = |k: usize| {
        let [across, a, b] = [0, 1, 2].map(|step| edges[(k / 2 + step) % 3]);
        if k.is_multiple_of(2) { plate(corner, a, b) } else { plate(corner + across, b, a) }
    };
    [0, 1, 2, 3, 4, 5].map(face)
}
