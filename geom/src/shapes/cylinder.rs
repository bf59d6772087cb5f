//! Cylinder wall: X(u, v) = o + R (cos φ x̂ + sin φ ŷ) + ½(1 + v) a, φ linear in u over the angle.
//!
//! Front: outside. Area (φ₁ − φ₀) R |a|. Range: R > 0, 0 < φ₁ − φ₀ ≤ 2π.
//!
//! A ray is measured from where it passes the axis line nearest, t* ± √(R² − d²)/|w|, d the distance there:
//! no cancellation for far origins.

use super::turn::{Profile, Turn};
use super::{check_finite, check_positive};
use crate::{Aabb, ConvexSolid, Hit, Jet, Meridian, Outline, Ray, Rect, ShapeError, Surface};
use glam::{DVec2, DVec3};

/// The wall of a circular cylinder, or a strip of it.
#[derive(Clone, Debug)]
pub struct Cylinder {
    turn: Turn,
    height: f64,
    radius: f64,
}

impl Cylinder {
    /// The wall of `radius` about the segment from `base` to `base + axis`, with `angle` from and to in
    /// radians.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, an axis of no length, a radius not above zero, a wrong range of angles.
    pub fn new(base: DVec3, axis: DVec3, radius: f64, angle: [f64; 2]) -> Result<Cylinder, ShapeError> {
        check_finite("base", base)?;
        check_positive("radius", radius)?;
        Ok(Cylinder { turn: Turn::new(base, "axis", axis, angle)?, height: axis.length(), radius })
    }
}

impl Surface for Cylinder {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let half = 0.5 * self.height;
        self.turn.jet(u, Profile { x: self.radius, z: (1.0 + v) * half, dx: 0.0, dz: half })
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        let [low, high] = rect.v.map(|v| 0.5 * (1.0 + v) * self.height);
        self.turn.bounds(rect.u, |g, h| self.radius * g + (low * h).max(high * h))
    }

    fn solid(&self) -> Option<ConvexSolid> {
        let (origin, axis) = (self.turn.origin, self.turn.axis());
        Some(ConvexSolid::Turned { origin, axis, outline: Outline::Line { radius: self.radius, slope: 0.0 } })
    }

    fn meridian(&self) -> Option<Meridian> {
        self.turn.meridian([0.0, self.height].map(|z| DVec2::new(self.radius, z)))
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let (o, w) = (self.turn.local_point(ray.origin), self.turn.local_vector(ray.direction));
        let (flat_o, flat_w) = (o.truncate(), w.truncate());
        let speed = flat_w.length_squared();
        let nearest = -flat_o.dot(flat_w) / speed;
        let inside = self.radius * self.radius - (flat_o + nearest * flat_w).length_squared();
        if inside < 0.0 {
            return None;
        }
        // A ray along the axis has speed 0 and meets the wall nowhere or everywhere; NaN fails every
        // comparison.
        let reach = (inside / speed).sqrt();
        let size = self.radius + self.height;
        [nearest - reach, nearest + reach].into_iter().filter(|t| ray.reaches(*t)).find_map(|t| {
            let local = o + t * w;
            self.turn.accept(ray, t, local, size, 2.0 * local.z / self.height - 1.0)
        })
    }

    fn area(&self) -> f64 {
        2.0 * self.turn.half() * self.radius * self.height
    }
}

#[cfg(test)]
mod tests {
    use super::super::FULL_TURN;
    use super::*;

    #[test]
    fn errors_name_the_field() {
        let new = |axis, radius| Cylinder::new(DVec3::ZERO, axis, radius, FULL_TURN).unwrap_err();
        assert_eq!(new(DVec3::Z, -1.0), ShapeError::NotPositive { field: "radius".into(), value: -1.0 });
        assert_eq!(new(DVec3::ZERO, 1.0), ShapeError::ZeroLength { field: "axis".into() });
        assert_eq!(Cylinder::new(DVec3::NAN, DVec3::Z, 1.0, FULL_TURN).unwrap_err().field(), "base");
    }

    #[test]
    fn rays_along_the_axis_pass() {
        let wall = Cylinder::new(DVec3::ZERO, DVec3::Z, 1.0, FULL_TURN).unwrap();
        assert!(!wall.occludes(&Ray::new(-DVec3::Z, DVec3::Z)));
        assert_eq!(wall.intersect(&Ray::new(DVec3::new(-3.0, 0.0, 0.5), DVec3::X)).unwrap().t, 2.0);
        assert_eq!(wall.intersect(&Ray::new(DVec3::new(0.0, 0.0, 0.5), DVec3::X)).unwrap().t, 1.0);
    }
}
