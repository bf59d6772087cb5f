//! Sphere between two heights: X(u, v) = c + R (cos ψ (cos φ x̂ + sin φ ŷ) + sin ψ ẑ), φ linear in u over the
//! angle, the latitude ψ linear in v between asin(z₀/R) and asin(z₁/R).
//!
//! Front: outside. Area (φ₁ − φ₀) R (z₁ − z₀) (Archimedes). At a pole the area element vanishes;
//! [`super::SpherePatch`] has none. Range: R > 0, −R ≤ z₀ < z₁ ≤ R.

use super::turn::{Profile, Turn};
use super::{check_finite, check_positive};
use crate::arc::arc_range;
use crate::{Aabb, ConvexSolid, Hit, Jet, Ray, Rect, ShapeError, Surface};
use glam::DVec3;

/// A zone of a sphere, or a part of it between two meridians.
#[derive(Clone, Debug)]
pub struct Sphere {
    turn: Turn,
    radius: f64,
    z: [f64; 2],
    /// Middle and half of the range of latitudes.
    latitude: [f64; 2],
}

impl Sphere {
    /// The part of the sphere about `center` whose height along `axis` from the centre lies in `z`, with
    /// `angle` from and to in radians.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, a radius not above zero, an axis of no length, heights out of order or
    /// beyond the radius, a wrong range of angles.
    pub fn new(
        center: DVec3,
        radius: f64,
        axis: DVec3,
        z: [f64; 2],
        angle: [f64; 2],
    ) -> Result<Sphere, ShapeError> {
        check_finite("center", center)?;
        check_positive("radius", radius)?;
        check_finite("z", DVec3::new(z[0], z[1], 0.0))?;
        let [low, high] = z;
        if low >= high {
            let limit = "its second number".into();
            return Err(ShapeError::OutOfOrder { field: "z".into(), limit, low, high });
        }
        if low < -radius || high > radius {
            return Err(ShapeError::OutOfRange {
                field: "z".into(),
                low,
                high,
                least: -radius,
                most: radius,
            });
        }
        let [south, north] = z.map(|z| (z / radius).asin());
        let latitude = [0.5 * (south + north), 0.5 * (north - south)];
        Ok(Sphere { turn: Turn::new(center, "axis", axis, angle)?, radius, z, latitude })
    }

    fn latitude_at(&self, v: f64) -> f64 {
        self.latitude[0] + v * self.latitude[1]
    }
}

impl Surface for Sphere {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let (sin, cos) = self.latitude_at(v).sin_cos();
        // Rounding must not push a pole to the far side of the axis.
        let x = self.radius * cos.max(0.0);
        let z = self.radius * sin;
        self.turn.jet(u, Profile { x, z, dx: -z * self.latitude[1], dz: x * self.latitude[1] })
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        let range = rect.v.map(|v| self.latitude_at(v));
        self.turn.bounds(rect.u, |g, h| self.radius * arc_range(g, h, range)[1])
    }

    fn ball(&self) -> Option<(DVec3, f64)> {
        let whole = self.turn.half() >= std::f64::consts::PI * (1.0 - 1e-12)
            && self.z[0] <= -self.radius * (1.0 - 1e-12)
            && self.z[1] >= self.radius * (1.0 - 1e-12);
        whole.then_some((self.turn.origin, self.radius))
    }

    fn solid(&self) -> Option<ConvexSolid> {
        Some(ConvexSolid::Ball { center: self.turn.origin, radius: self.radius })
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let roots = meet(self.turn.origin, self.radius, ray);
        roots.into_iter().filter(|t| ray.reaches(*t)).find_map(|t| {
            let local = self.turn.local_point(ray.at(t));
            let latitude = local.z.atan2(local.truncate().length());
            let v = (latitude - self.latitude[0]) / self.latitude[1];
            self.turn.accept(ray, t, local, self.radius, v)
        })
    }

    fn area(&self) -> f64 {
        2.0 * self.turn.half() * self.radius * (self.z[1] - self.z[0])
    }
}

/// Where the ray's line meets the sphere, nearest first; NaN where it passes by. Measured from the point
/// nearest to the centre, so that far origins lose nothing.
pub(super) fn meet(center: DVec3, radius: f64, ray: &Ray) -> [f64; 2] {
    let speed = ray.direction.length_squared();
    let nearest = (center - ray.origin).dot(ray.direction) / speed;
    let off = (ray.at(nearest) - center).length_squared();
    let reach = ((radius * radius - off) / speed).sqrt();
    [nearest - reach, nearest + reach]
}

#[cfg(test)]
mod tests {
    use super::super::FULL_TURN;
    use super::*;

    #[test]
    fn only_a_whole_sphere_bounds_a_ball() {
        let part = |z, angle| Sphere::new(DVec3::X, 2.0, DVec3::Z, z, angle).unwrap().ball();
        assert_eq!(part([-2.0, 2.0], FULL_TURN), Some((DVec3::X, 2.0)));
        assert_eq!(part([-2.0, 1.9], FULL_TURN), None);
        assert_eq!(part([-2.0, 2.0], [0.0, 6.0]), None);
    }

    #[test]
    fn errors_name_the_field() {
        let new = |radius, z| Sphere::new(DVec3::ZERO, radius, DVec3::Z, z, FULL_TURN).unwrap_err();
        assert_eq!(new(0.0, [-1.0, 1.0]).field(), "radius");
        assert!(matches!(new(1.0, [0.5, 0.5]), ShapeError::OutOfOrder { .. }));
        assert!(matches!(new(1.0, [-1.5, 0.5]), ShapeError::OutOfRange { .. }));
    }

    #[test]
    fn poles_have_normals() {
        let ball = Sphere::new(DVec3::ZERO, 2.0, DVec3::Z, [-2.0, 2.0], FULL_TURN).unwrap();
        assert!(ball.jet(0.3, 1.0).normal.distance(DVec3::Z) < 1e-15);
        assert!(ball.jet(0.3, -1.0).normal.distance(-DVec3::Z) < 1e-15);
        let far = ball.intersect(&Ray::new(DVec3::new(1e8, 0.0, 1.0), -DVec3::X)).unwrap();
        assert!((far.t - (1e8 - 3.0_f64.sqrt())).abs() < 1e-7);
    }
}
