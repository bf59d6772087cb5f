//! Rays against boxes: each of the three slabs of a box meets the ray in an interval of t; the box meets it
//! in their intersection.

use crate::{Aabb, Ray};
use glam::DVec3;

/// A ray prepared for box tests.
pub(crate) struct Slabs {
    origin: DVec3,
    inverse: DVec3,
}

impl Slabs {
    pub(crate) fn new(ray: &Ray) -> Slabs {
        Slabs { origin: ray.origin, inverse: inverted(ray.direction) }
    }

    /// Where the ray enters the box, if it does so between `start` and `end`. Rounding decides about rays
    /// within the plane of a face: boxes need a margin around their content.
    pub(crate) fn entry(&self, bounds: &Aabb, start: f64, end: f64) -> Option<f64> {
        let a = (bounds.min - self.origin) * self.inverse;
        let b = (bounds.max - self.origin) * self.inverse;
        let entry = a.min(b).max_element().max(start);
        let exit = a.max(b).min_element().min(end);
        (entry <= exit).then_some(entry)
    }
}

/// One over each coordinate, huge instead of infinite: 0 · ∞ must not arise for rays within a slab's plane.
pub(crate) fn inverted(direction: DVec3) -> DVec3 {
    direction.map(|x| if x.abs() < 1e-290 { 1e290_f64.copysign(x) } else { 1.0 / x })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_within_a_face_are_not_lost() {
        let unit = Aabb { min: DVec3::ZERO, max: DVec3::ONE }.inflate(1e-9);
        let entry =
            |o: [f64; 3], d: DVec3| Slabs::new(&Ray::new(o.into(), d)).entry(&unit, 0.0, f64::INFINITY);
        for (y, z) in [(1.0, 0.5), (0.0, 0.0), (1.0, 0.0)] {
            assert!((entry([-2.0, y, z], DVec3::X).unwrap() - 2.0).abs() < 1e-8);
        }
        assert_eq!(entry([-2.0, 1.1, 0.5], DVec3::X), None);
        assert_eq!(entry([2.0, 0.5, 0.5], DVec3::X), None);
        assert_eq!(entry([0.5, 0.5, 0.5], -DVec3::Z), Some(0.0));
    }
}
