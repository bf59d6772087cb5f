//! Surfaces turned about an axis: X(u, v) = o + x(v) r̂(φ) + z(v) ẑ with φ = φ₀ + u φ₁.
//!
//! Angle 0 points toward the projection of +x (of +y where the axis is along x); angles run right-handed
//! about the axis. X_u = x φ₁ φ̂, X_v = x′ r̂ + z′ ẑ, so X_u × X_v = x φ₁ (z′ r̂ − x′ ẑ): the normal is
//! finite even where x = 0, and the front is the outside of a profile that runs upward. The profile keeps x ≥
//! 0.

use super::{check_edge, check_finite};
use crate::arc::arc_range;
use crate::{Aabb, Hit, Jet, Meridian, ROUNDING, Ray, ShapeError};
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// A place on the profile: distance from the axis, height along it, and their derivatives by v.
pub(super) struct Profile {
    pub(super) x: f64,
    pub(super) z: f64,
    pub(super) dx: f64,
    pub(super) dz: f64,
}

/// An axis and a range of angles about it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) origin: DVec3,
    axes: [DVec3; 3],
    middle: f64,
    half: f64,
}

impl Turn {
    /// The range `angle` (radians) about the line through `origin` along `axis`, which `field` names.
    pub(super) fn new(origin: DVec3, field: &str, axis: DVec3, angle: [f64; 2]) -> Result<Turn, ShapeError> {
        check_edge(field, axis)?;
        let z = axis.normalize();
        let toward = |e: DVec3| e - e.dot(z) * z;
        let x =
            if toward(DVec3::X).length() > 1e-6 { toward(DVec3::X) } else { toward(DVec3::Y) }.normalize();
        let [middle, half] = check_angle("angle", angle)?;
        Ok(Turn { origin, axes: [x, z.cross(x), z], middle, half })
    }

    /// Half the range of angles: dφ/du.
    pub(super) fn half(&self) -> f64 {
        self.half
    }

    /// The meridian between `ends`, where the range is all the way round.
    pub(super) fn meridian(&self, ends: [DVec2; 2]) -> Option<Meridian> {
        let is_whole = self.half >= PI * (1.0 - ROUNDING);
        is_whole.then(|| Meridian::new(self.origin, self.axis(), ends))
    }

    /// Unit vector along the axis.
    pub(super) fn axis(&self) -> DVec3 {
        self.axes[2]
    }

    pub(super) fn local_point(&self, p: DVec3) -> DVec3 {
        self.local_vector(p - self.origin)
    }

    pub(super) fn local_vector(&self, d: DVec3) -> DVec3 {
        DVec3::from_array(self.axes.map(|axis| d.dot(axis)))
    }

    pub(super) fn jet(&self, u: f64, at: Profile) -> Jet {
        let (sin, cos) = (self.middle + u * self.half).sin_cos();
        let [x, y, z] = self.axes;
        let (radial, around) = (cos * x + sin * y, cos * y - sin * x);
        let speed = (at.dx * at.dx + at.dz * at.dz).sqrt();
        Jet {
            position: self.origin + at.x * radial + at.z * z,
            du: at.x * self.half * around,
            dv: at.dx * radial + at.dz * z,
            normal: (at.dz * radial - at.dx * z) / speed,
            area: at.x * self.half * speed,
        }
    }

    /// The hit at a local point with the parameter v, of a shape of the given size, if the point belongs to
    /// it.
    pub(super) fn accept(&self, ray: &Ray, t: f64, local: DVec3, size: f64, v: f64) -> Option<Hit> {
        // Most lines meet a shape beyond its ends, and an angle takes longer than all the rest.
        if v.abs() <= 1.0 + Hit::SEAM { Hit::accept(ray, t, self.parameter(local, size), v) } else { None }
    }

    /// The parameter u of a local point, of a shape of the given size. Near the axis the angle of a point is
    /// uncertain, so the seam tolerance there is that of a length.
    fn parameter(&self, local: DVec3, size: f64) -> f64 {
        let angle = local.y.atan2(local.x) - self.middle;
        let u = (angle - TAU * (angle / TAU).round()) / self.half;
        let beyond = (u.abs() - 1.0) * self.half * local.truncate().length();
        if beyond <= Hit::SEAM * size { u.clamp(-1.0, 1.0) } else { u }
    }

    /// The box around all points with u in `range` and (x, z) on the profile; `support(g, h)` is the largest
    /// x g + z h there.
    pub(super) fn bounds(&self, range: [f64; 2], support: impl Fn(f64, f64) -> f64) -> Aabb {
        let [start, end] = range.map(|u| self.middle + u * self.half);
        let mut bounds = Aabb { min: self.origin, max: self.origin };
        for k in 0..3 {
            let [least, most] = arc_range(self.axes[0][k], self.axes[1][k], [start, end]);
            bounds.min[k] -= support(-least, -self.axes[2][k]);
            bounds.max[k] += support(most, self.axes[2][k]);
        }
        bounds
    }
}

/// Middle and half of a range of angles, if it is one.
pub(super) fn check_angle(field: &str, angle: [f64; 2]) -> Result<[f64; 2], ShapeError> {
    let [low, high] = angle;
    check_finite(field, DVec3::new(low, high, 0.0))?;
    if low >= high {
        return Err(ShapeError::OutOfOrder {
            field: field.into(),
            limit: "its second number".into(),
            low,
            high,
        });
    }
    if high - low > TAU * (1.0 + 1e-12) {
        return Err(ShapeError::OutOfRange { field: field.into(), low, high, least: low, most: low + TAU });
    }
    Ok([0.5 * (low + high), 0.5 * (high - low)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angle_zero_points_along_x_or_y() {
        let radial = |axis| Turn::new(DVec3::ZERO, "axis", axis, [0.0, TAU]).unwrap().axes[0];
        assert_eq!(radial(2.0 * DVec3::Z), DVec3::X);
        assert_eq!(radial(-DVec3::X), DVec3::Y);
        assert!((radial(DVec3::ONE).cross(DVec3::X).dot(DVec3::ONE)).abs() < 1e-15);
    }

    #[test]
    fn wrong_angles_are_refused() {
        let turn = |angle| Turn::new(DVec3::ZERO, "axis", DVec3::Z, angle).unwrap_err();
        assert!(matches!(turn([1.0, 1.0]), ShapeError::OutOfOrder { .. }));
        assert!(matches!(turn([0.0, 7.0]), ShapeError::OutOfRange { .. }));
        assert_eq!(turn([f64::NAN, 1.0]).field(), "angle");
        assert_eq!(Turn::new(DVec3::ZERO, "normal", DVec3::ZERO, [0.0, 1.0]).unwrap_err().field(), "normal");
    }
}
