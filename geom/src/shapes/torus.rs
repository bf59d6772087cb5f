//! Torus: X(u, v) = c + (R + r cos ψ)(cos φ x̂ + sin φ ŷ) + r sin ψ ẑ, φ linear in u over the angle about the
//! axis, ψ linear in v over the angle about the tube (0 at the outer equator, toward the axis' head).
//!
//! Front: outside of the tube. Area (φ₁ − φ₀) r (R (ψ₁ − ψ₀) + r (sin ψ₁ − sin ψ₀)). Range: R > r > 0.
//!
//! Ray: with p = o + t w, (|p|² + R² − r²)² = 4 R² (p_x² + p_y²), a quartic. Its Bernstein form over the
//! ray's stretch inside the enclosing sphere isolates every root; each is then refined on the distance from
//! the tube, √((ρ − R)² + z²) − r, which keeps the digits the quartic loses for thin tubes.

use super::sphere::meet;
use super::turn::{Profile, Turn, check_angle};
use super::{check_finite, check_positive};
use crate::arc::arc_range;
use crate::bernstein::from_powers;
use crate::roots;
use crate::tolerances::ROUNDING;
use crate::{Aabb, ConvexSolid, Hit, Jet, Outline, Ray, Rect, ShapeError, Surface};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// A ring torus, or a part of it.
#[derive(Clone, Debug)]
pub struct Torus {
    turn: Turn,
    major: f64,
    minor: f64,
    /// Middle and half of the range of angles about the tube.
    tube: [f64; 2],
}

impl Torus {
    /// The torus whose tube of radius `minor` runs about the circle of radius `major` around `center`, across
    /// `axis`. `angle` about the axis and `tube_angle` about the tube from and to in radians.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, radii not 0 < minor < major, an axis of no length, a wrong range of
    /// angles.
    pub fn new(
        center: DVec3,
        axis: DVec3,
        major: f64,
        minor: f64,
        angle: [f64; 2],
        tube_angle: [f64; 2],
    ) -> Result<Torus, ShapeError> {
        check_finite("center", center)?;
        check_positive("major", major)?;
        check_positive("minor", minor)?;
        if minor >= major {
            let (field, limit) = ("minor".into(), "`major`".into());
            return Err(ShapeError::OutOfOrder { field, limit, low: minor, high: major });
        }
        let tube = check_angle("tube_angle", tube_angle)?;
        Ok(Torus { turn: Turn::new(center, "axis", axis, angle)?, major, minor, tube })
    }

    fn tube_at(&self, v: f64) -> f64 {
        self.tube[0] + v * self.tube[1]
    }

    /// The quartic along p + s w, lowest power first.
    fn quartic(&self, p: DVec3, w: DVec3) -> [f64; 5] {
        let (pp, pw, ww) = (p.length_squared(), p.dot(w), w.length_squared());
        let k = pp + self.major * self.major - self.minor * self.minor;
        let m = 4.0 * self.major * self.major;
        let flat = (p.truncate(), w.truncate());
        [
            k * k - m * flat.0.length_squared(),
            4.0 * k * pw - 2.0 * m * flat.0.dot(flat.1),
            2.0 * k * ww + 4.0 * pw * pw - m * flat.1.length_squared(),
            4.0 * pw * ww,
            ww * ww,
        ]
    }

    /// Newton's method on the distance from the tube; `None` where the line does not come that near.
    fn refine(&self, o: DVec3, w: DVec3, mut t: f64) -> Option<f64> {
        let mut off = f64::INFINITY;
        for _ in 0..4 {
            let p = o + t * w;
            let flat = p.truncate();
            let from_circle = DVec2::new(flat.length() - self.major, p.z);
            let tube = from_circle.length();
            off = tube - self.minor;
            if off.abs() <= 1e-16 * self.major {
                break;
            }
            let outward = flat.dot(w.truncate()) / flat.length();
            let step = off * tube / from_circle.dot(DVec2::new(outward, w.z));
            if step.is_finite() && step.abs() * w.length() < self.minor {
                t -= step;
            }
        }
        (off.abs() <= 1e-12 * self.major).then_some(t)
    }

    fn accept(&self, ray: &Ray, o: DVec3, w: DVec3, t: f64) -> Option<Hit> {
        let p = o + t * w;
        let angle = p.z.atan2(p.truncate().length() - self.major) - self.tube[0];
        let v = (angle - TAU * (angle / TAU).round()) / self.tube[1];
        self.turn.accept(ray, t, p, self.major, v)
    }
}

impl Surface for Torus {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let (sin, cos) = self.tube_at(v).sin_cos();
        let (x, z) = (self.minor * cos, self.minor * sin);
        self.turn.jet(u, Profile { x: self.major + x, z, dx: -z * self.tube[1], dz: x * self.tube[1] })
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        let range = rect.v.map(|v| self.tube_at(v));
        self.turn.bounds(rect.u, |g, h| self.major * g + self.minor * arc_range(g, h, range)[1])
    }

    /// The outer half of the tube.
    fn solid(&self) -> Option<ConvexSolid> {
        let [low, high] = [-1.0, 1.0].map(|v| self.tube_at(v));
        let outline = Outline::Arc { center: DVec2::X * self.major, radius: self.minor, angles: [low, high] };
        let faces_out = [low, self.tube[0], high].iter().all(|angle| angle.cos() >= -ROUNDING);
        let is_outside = faces_out && high - low <= PI + ROUNDING;
        is_outside.then_some(ConvexSolid::Turned {
            origin: self.turn.origin,
            axis: self.turn.axis(),
            outline,
        })
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let [enter, leave] = meet(self.turn.origin, 1.001 * (self.major + self.minor), ray);
        let (start, end) = (enter.max(ray.range[0]), leave.min(ray.range[1]));
        if !(enter <= leave && start <= end) {
            return None;
        }
        // The whole stretch, so that a hit at the range's very end is not lost to rounding.
        let (o, w) = (self.turn.local_point(ray.origin), self.turn.local_vector(ray.direction));
        let length = leave - enter;
        let quartic = from_powers(self.quartic(o + enter * w, length * w));
        let mut best: Option<Hit> = None;
        roots::bernstein(quartic, |s| {
            let hit = self.refine(o, w, enter + s * length).and_then(|t| self.accept(ray, o, w, t));
            best = [best, hit].into_iter().flatten().min_by(|a, b| a.t.total_cmp(&b.t));
        });
        best
    }

    fn area(&self) -> f64 {
        let [south, north] = [-1.0, 1.0].map(|v| self.tube_at(v));
        let bulge = self.minor * (north.sin() - south.sin());
        2.0 * self.turn.half() * self.minor * (2.0 * self.major * self.tube[1] + bulge)
    }
}

#[cfg(test)]
mod tests {
    use super::super::FULL_TURN;
    use super::*;

    #[test]
    fn errors_name_the_field() {
        let new = |major, minor, tube| {
            Torus::new(DVec3::ZERO, DVec3::Z, major, minor, FULL_TURN, tube).unwrap_err()
        };
        assert_eq!(new(1.0, 1.0, FULL_TURN).field(), "minor");
        assert_eq!(new(-1.0, 1.0, FULL_TURN).field(), "major");
        assert_eq!(new(2.0, 1.0, [0.0, 9.0]).field(), "tube_angle");
    }

    #[test]
    fn a_line_through_the_hole_passes_and_one_across_meets_four_walls() {
        let ring = Torus::new(DVec3::ZERO, DVec3::Z, 2.0, 0.5, FULL_TURN, FULL_TURN).unwrap();
        assert!(!ring.occludes(&Ray::new(DVec3::new(0.1, 0.2, 5.0), -DVec3::Z)));
        let mut from = -5.0;
        for wall in [-2.5, -1.5, 1.5, 2.5] {
            let hit = ring
                .intersect(&Ray { range: [from + 1e-6, 99.0], ..Ray::new(DVec3::ZERO, DVec3::X) })
                .unwrap();
            assert!((hit.t - wall).abs() < 1e-14, "{} instead of {wall}", hit.t);
            from = hit.t;
        }
        // Just below the top circle the line is within 1e-13 of it over a millimetre: a nearly fourfold root.
        let top = ring.intersect(&Ray::new(DVec3::new(2.0, -3.0, 0.5 - 1e-13), DVec3::Y)).unwrap();
        assert!((top.t - 3.0).abs() < 2e-3);
    }
}
