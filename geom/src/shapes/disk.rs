//! Disk, ring or sector: X(u, v) = c + r (cos φ x̂ + sin φ ŷ), φ linear in u over the angle, r linear in v
//! from the rim inward.
//!
//! r = R − ½(1 + v)(R − r₀). Front: the normal. Area ½ (φ₁ − φ₀)(R² − r₀²). At the centre the area element
//! vanishes. Range: 0 ≤ r₀ < R, 0 < φ₁ − φ₀ ≤ 2π.

use super::turn::{Profile, Turn};
use super::{check_finite, check_positive};
use crate::{Aabb, Hit, Jet, Meridian, Ray, Rect, ShapeError, Surface};
use glam::{DVec2, DVec3};

/// A flat disk, ring, or sector of one.
#[derive(Clone, Debug)]
pub struct Disk {
    turn: Turn,
    radius: f64,
    inner: f64,
}

impl Disk {
    /// The part of the disk about `center`, facing along `normal`, between `inner_radius` and `radius`, with
    /// `angle` from and to in radians ([`super::FULL_TURN`] for all of it).
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, a normal of no length, radii not 0 ≤ inner < outer, a wrong range of
    /// angles.
    pub fn new(
        center: DVec3,
        normal: DVec3,
        radius: f64,
        inner_radius: f64,
        angle: [f64; 2],
    ) -> Result<Disk, ShapeError> {
        check_finite("center", center)?;
        check_positive("radius", radius)?;
        super::check_not_negative("inner_radius", inner_radius)?;
        if inner_radius >= radius {
            let (field, limit) = ("inner_radius".into(), "`radius`".into());
            return Err(ShapeError::OutOfOrder { field, limit, low: inner_radius, high: radius });
        }
        Ok(Disk { turn: Turn::new(center, "normal", normal, angle)?, radius, inner: inner_radius })
    }

    fn radius_at(&self, v: f64) -> f64 {
        self.radius - 0.5 * (1.0 + v) * (self.radius - self.inner)
    }
}

impl Surface for Disk {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let dx = -0.5 * (self.radius - self.inner);
        self.turn.jet(u, Profile { x: self.radius_at(v), z: 0.0, dx, dz: 0.0 })
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        let [outer, inner] = rect.v.map(|v| self.radius_at(v));
        self.turn.bounds(rect.u, |g, _| (outer * g).max(inner * g))
    }

    fn meridian(&self) -> Option<Meridian> {
        self.turn.meridian([self.radius, self.inner].map(|r| DVec2::new(r, 0.0)))
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let axis = self.turn.axis();
        let t = (self.turn.origin - ray.origin).dot(axis) / ray.direction.dot(axis);
        if !ray.reaches(t) {
            return None;
        }
        let local = self.turn.local_point(ray.at(t));
        let v = 2.0 * (self.radius - local.truncate().length()) / (self.radius - self.inner) - 1.0;
        self.turn.accept(ray, t, local, self.radius, v)
    }

    fn area(&self) -> f64 {
        self.turn.half() * (self.radius - self.inner) * (self.radius + self.inner)
    }
}

#[cfg(test)]
mod tests {
    use super::super::FULL_TURN;
    use super::*;

    #[test]
    fn radii_must_be_ordered() {
        let disk = |radius, inner| Disk::new(DVec3::ZERO, DVec3::Z, radius, inner, FULL_TURN).unwrap_err();
        assert_eq!(disk(0.0, 0.0), ShapeError::NotPositive { field: "radius".into(), value: 0.0 });
        assert_eq!(disk(1.0, 1.0).field(), "inner_radius");
        assert!(matches!(disk(1.0, -0.1), ShapeError::Negative { .. }));
        assert_eq!(disk(f64::NAN, 0.0), ShapeError::NotFinite { field: "radius".into() });
    }

    #[test]
    fn the_middle_of_a_sector_is_hit() {
        let quarter = Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, [0.0, 0.5 * std::f64::consts::PI]).unwrap();
        assert!(quarter.occludes(&Ray::new(DVec3::Z, -DVec3::Z)));
        assert!(!quarter.occludes(&Ray::new(DVec3::new(-0.1, -0.1, 1.0), -DVec3::Z)));
        assert_eq!(quarter.jet(0.0, 1.0).normal, DVec3::Z);
    }
}
