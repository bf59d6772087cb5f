//! Cone or frustum: X(u, v) = o + r (cos φ x̂ + sin φ ŷ) + ½(1 + v) a, with r = R₁ + ½(1 + v)(R₂ − R₁), φ
//! linear in u.
//!
//! Front: outside. Area ½ (φ₁ − φ₀)(R₁ + R₂) √(|a|² + (R₂ − R₁)²). Range: R₁, R₂ ≥ 0, not both 0. At an apex
//! the normal is its limit along the ruling.
//!
//! Ray: x² + y² = (R₁ + k z)², a quadratic in t, taken from the ray's point nearest to the middle of the
//! narrow end, so that rays through an apex keep their digits.

use super::turn::{Profile, Turn};
use super::{check_finite, check_not_negative};
use crate::roots::quadratic;
use crate::{Aabb, ConvexSolid, Hit, Jet, Meridian, Outline, Ray, Rect, ShapeError, Surface};
use glam::{DVec2, DVec3};

/// The wall of a circular cone or frustum, or a strip of it.
#[derive(Clone, Debug)]
pub struct Cone {
    turn: Turn,
    height: f64,
    radius1: f64,
    radius2: f64,
}

impl Cone {
    /// The wall about the segment from `base` (radius `radius1`) to `base + axis` (radius `radius2`), with
    /// `angle` from and to in radians.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, an axis of no length, a negative radius or none above zero, a wrong range
    /// of angles.
    pub fn new(
        base: DVec3,
        axis: DVec3,
        radius1: f64,
        radius2: f64,
        angle: [f64; 2],
    ) -> Result<Cone, ShapeError> {
        check_finite("base", base)?;
        check_not_negative("radius1", radius1)?;
        check_not_negative("radius2", radius2)?;
        if radius1 == 0.0 && radius2 == 0.0 {
            return Err(ShapeError::NotPositive { field: "radius1".into(), value: radius1 });
        }
        Ok(Cone { turn: Turn::new(base, "axis", axis, angle)?, height: axis.length(), radius1, radius2 })
    }

    fn radius_at(&self, v: f64) -> f64 {
        self.radius1 + 0.5 * (1.0 + v) * (self.radius2 - self.radius1)
    }

    /// The ray's line against the whole double cone, in local coordinates: both t.
    fn meet(&self, o: DVec3, w: DVec3) -> [f64; 2] {
        let slope = (self.radius2 - self.radius1) / self.height;
        let (end, least) =
            if self.radius1 <= self.radius2 { (0.0, self.radius1) } else { (self.height, self.radius2) };
        let from = o - DVec3::new(0.0, 0.0, end);
        let near = -from.dot(w) / w.length_squared();
        let p = from + near * w;
        let (radius, growth) = (least + slope * p.z, slope * w.z);
        let a = w.x * w.x + w.y * w.y - growth * growth;
        let b = 2.0 * (p.x * w.x + p.y * w.y - radius * growth);
        let c = p.x * p.x + p.y * p.y - radius * radius;
        quadratic(a, b, c).map(|t| near + t)
    }

    /// The parameter v of a local point of the double cone, by its place along the slant: of a flat cone the
    /// height alone says little.
    fn along(&self, local: DVec3) -> f64 {
        let widening = self.radius2 - self.radius1;
        let on_other_nappe = self.radius1 + widening * local.z / self.height < 0.0;
        let distance = local.truncate().length();
        let radius = if on_other_nappe { -distance } else { distance };
        let slant = widening * widening + self.height * self.height;
        2.0 * (widening * (radius - self.radius1) + self.height * local.z) / slant - 1.0
    }
}

impl Surface for Cone {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let half = 0.5 * self.height;
        let dx = 0.5 * (self.radius2 - self.radius1);
        self.turn.jet(u, Profile { x: self.radius_at(v), z: (1.0 + v) * half, dx, dz: half })
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        let ends = rect.v.map(|v| (self.radius_at(v), 0.5 * (1.0 + v) * self.height));
        self.turn.bounds(rect.u, |g, h| ends.map(|(x, z)| x * g + z * h).into_iter().fold(f64::MIN, f64::max))
    }

    fn solid(&self) -> Option<ConvexSolid> {
        let (origin, axis) = (self.turn.origin, self.turn.axis());
        let slope = (self.radius2 - self.radius1) / self.height;
        Some(ConvexSolid::Turned { origin, axis, outline: Outline::Line { radius: self.radius1, slope } })
    }

    fn meridian(&self) -> Option<Meridian> {
        self.turn.meridian([DVec2::new(self.radius1, 0.0), DVec2::new(self.radius2, self.height)])
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let (o, w) = (self.turn.local_point(ray.origin), self.turn.local_vector(ray.direction));
        let size = self.radius1.max(self.radius2) + self.height;
        let hits = self.meet(o, w).into_iter().filter(|t| ray.reaches(*t)).filter_map(|t| {
            let local = o + t * w;
            self.turn.accept(ray, t, local, size, self.along(local))
        });
        hits.min_by(|a, b| a.t.total_cmp(&b.t))
    }

    fn area(&self) -> f64 {
        let slant = self.height.hypot(self.radius2 - self.radius1);
        self.turn.half() * (self.radius1 + self.radius2) * slant
    }
}

#[cfg(test)]
mod tests {
    use super::super::FULL_TURN;
    use super::*;

    #[test]
    fn errors_name_the_field() {
        let new = |r1, r2| Cone::new(DVec3::ZERO, DVec3::Z, r1, r2, FULL_TURN).unwrap_err();
        assert_eq!(new(0.0, 0.0).field(), "radius1");
        assert_eq!(new(1.0, -1.0), ShapeError::Negative { field: "radius2".into(), value: -1.0 });
        assert_eq!(Cone::new(DVec3::ZERO, DVec3::ZERO, 1.0, 0.0, FULL_TURN).unwrap_err().field(), "axis");
    }

    #[test]
    fn the_other_nappe_is_not_part_of_it() {
        let cone = Cone::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).unwrap();
        assert!(!cone.occludes(&Ray::new(DVec3::new(-3.0, 0.0, 1.5), DVec3::X)));
        let hit = cone.intersect(&Ray::new(DVec3::new(0.0, 0.0, 3.0), -DVec3::Z)).unwrap();
        assert!((hit.t - 2.0).abs() < 1e-12 && hit.v == 1.0);
        // Along a ruling the quadratic degenerates to one root or none.
        let grazing = Ray::new(DVec3::new(1.0, 0.0, 1e-3), DVec3::new(-1.0, 0.0, 1.0));
        assert!(!cone.occludes(&grazing));
        let apex = cone.jet(0.0, 1.0);
        assert!((apex.normal.length() - 1.0).abs() < 1e-15 && apex.area == 0.0);
    }

    /// From within the nappe a line through the apex meets the cone there and nowhere else.
    #[test]
    fn rays_through_the_apex_hit_it() {
        for (radius1, radius2, apex) in [(1.0, 0.0, 1.0), (0.0, 1.0, 0.0)] {
            let axis = DVec3::new(1.0, 2.0, 2.0) / 3.0;
            let cone = Cone::new(DVec3::ONE, axis, radius1, radius2, FULL_TURN).unwrap();
            let target = DVec3::ONE + apex * axis;
            let [e, f] = <[DVec3; 2]>::from(axis.any_orthonormal_pair());
            for k in 0..500 {
                let (sin, cos) = (0.1 * f64::from(k)).sin_cos();
                let direction = axis + 0.0019 * f64::from(k) * (cos * e + sin * f);
                let hit = cone.intersect(&Ray::new(target - 3.0 * direction, direction));
                assert!(hit.is_some_and(|hit| (hit.t - 3.0).abs() < 1e-13), "{k}: {hit:?}");
            }
        }
    }

    #[test]
    fn hits_of_a_flat_cone_lie_on_it() {
        let cone = Cone::new(DVec3::ZERO, 1e-4 * DVec3::Z, 0.0, 1.0, FULL_TURN).unwrap();
        for k in 0..500 {
            let (u, v) = ((0.7 * f64::from(k)).sin(), (1.3 * f64::from(k)).sin());
            let target = cone.jet(u, v).position;
            let direction = DVec3::new((0.3 * f64::from(k)).sin(), (0.9 * f64::from(k)).sin(), -0.4);
            let ray = Ray { range: [0.9, 1.1], ..Ray::new(target - direction, direction) };
            let hit = cone.intersect(&ray).unwrap();
            assert!(cone.jet(hit.u, hit.v).position.distance(ray.at(hit.t)) < 1e-12, "{u} {v} {hit:?}");
        }
    }
}
