//! Rigid motions with a uniform scale: x ↦ σ R x + τ.

use crate::ShapeError;
use glam::{DMat3, DQuat, DVec3};

/// A uniform scale, a rotation about an axis through the origin, and a translation, in this order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    translation: DVec3,
    rotation: DMat3,
    scale: f64,
}

impl Motion {
    /// Leaves everything where it is.
    pub const IDENTITY: Motion = Motion { translation: DVec3::ZERO, rotation: DMat3::IDENTITY, scale: 1.0 };

    /// Scales by `scale`, turns by `angle` (radians, right-handed) about `axis`, then moves by `translate`.
    /// The axis may have any length, and none where the angle is 0.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite (`translate`, `rotate`), a scale not above zero, an angle about no axis.
    pub fn new(translate: DVec3, axis: DVec3, angle: f64, scale: f64) -> Result<Motion, ShapeError> {
        if !translate.is_finite() {
            return Err(ShapeError::NotFinite { field: "translate".into() });
        }
        if !axis.is_finite() || !angle.is_finite() {
            return Err(ShapeError::NotFinite { field: "rotate".into() });
        }
        if !scale.is_finite() {
            return Err(ShapeError::NotFinite { field: "scale".into() });
        }
        if scale <= 0.0 {
            return Err(ShapeError::NotPositive { field: "scale".into(), value: scale });
        }
        let rotation = match axis.try_normalize() {
            Some(axis) => DMat3::from_axis_angle(axis, angle),
            None if angle == 0.0 => DMat3::IDENTITY,
            None => return Err(ShapeError::ZeroLength { field: "rotate".into() }),
        };
        Ok(Motion { translation: translate, rotation, scale })
    }

    /// Turns by the unit quaternion `rotation`, then moves by `translation`: all distances stay.
    pub fn rigid(rotation: DQuat, translation: DVec3) -> Motion {
        Motion { translation, rotation: DMat3::from_quat(rotation), scale: 1.0 }
    }

    /// Takes the origin to `origin` and the unit vectors of the coordinates to `axes`, which are such vectors of
    /// another right-handed frame: all distances stay.
    pub fn to_frame(origin: DVec3, axes: [DVec3; 3]) -> Motion {
        let [x, y, z] = axes;
        Motion { translation: origin, rotation: DMat3::from_cols(x, y, z), scale: 1.0 }
    }

    /// The motion that takes every image back.
    #[must_use]
    pub fn inverse(&self) -> Motion {
        let (rotation, scale) = (self.rotation.transpose(), 1.0 / self.scale);
        Motion { translation: -(scale * (rotation * self.translation)), rotation, scale }
    }

    /// This motion and then `next`.
    #[must_use]
    pub fn then(&self, next: &Motion) -> Motion {
        Motion {
            translation: next.point(self.translation),
            rotation: next.rotation * self.rotation,
            scale: next.scale * self.scale,
        }
    }

    /// All of its numbers: motions of the same ones do the same to the bit.
    pub fn bits(&self) -> [u64; 13] {
        let columns = self.rotation.to_cols_array();
        let numbers = columns.iter().chain(self.translation.as_ref()).chain([&self.scale]);
        let mut bits = [0; 13];
        bits.iter_mut().zip(numbers).for_each(|(bits, number)| *bits = number.to_bits());
        bits
    }

    /// The factor by which lengths grow.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The image of a point.
    pub fn point(&self, x: DVec3) -> DVec3 {
        self.scale * (self.rotation * x) + self.translation
    }

    /// The image of a difference of points.
    pub fn vector(&self, d: DVec3) -> DVec3 {
        self.scale * (self.rotation * d)
    }

    /// The image of a unit vector, again of unit length.
    pub fn direction(&self, d: DVec3) -> DVec3 {
        self.rotation * d
    }

    /// The point with the image `x`.
    pub fn point_back(&self, x: DVec3) -> DVec3 {
        self.rotation.transpose() * (x - self.translation) / self.scale
    }

    /// The difference of points with the image `d`.
    pub fn vector_back(&self, d: DVec3) -> DVec3 {
        self.rotation.transpose() * d / self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_go_back() {
        let motion = Motion::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 1.0, 0.0), 0.7, 2.5).unwrap();
        let x = DVec3::new(0.3, -4.0, 2.0);
        assert!(motion.point_back(motion.point(x)).distance(x) < 1e-14);
        assert!((motion.vector(x).length() - 2.5 * x.length()).abs() < 1e-14);
        let quarter = Motion::new(DVec3::X, 3.0 * DVec3::Z, std::f64::consts::FRAC_PI_2, 2.0).unwrap();
        assert!(quarter.point(DVec3::X).distance(DVec3::new(1.0, 2.0, 0.0)) < 1e-15);
    }

    #[test]
    fn one_motion_after_another_is_a_motion() {
        let first = Motion::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 1.0, 0.0), 0.7, 2.5).unwrap();
        let next = Motion::new(DVec3::new(-4.0, 0.5, 1.0), DVec3::new(0.0, 1.0, 3.0), -1.3, 0.4).unwrap();
        let (both, x) = (first.then(&next), DVec3::new(0.3, -4.0, 2.0));
        assert!(both.point(x).distance(next.point(first.point(x))) < 1e-14);
        assert!(both.vector(x).distance(next.vector(first.vector(x))) < 1e-14);
        assert_eq!(first.then(&Motion::IDENTITY), first);
        assert_eq!(Motion::IDENTITY.then(&first), first);
        let back = both.inverse();
        assert!(back.point(both.point(x)).distance(x) < 1e-14);
        assert!(back.point(x).distance(both.point_back(x)) < 1e-14);
    }

    #[test]
    fn a_quaternion_and_an_axis_with_its_angle_turn_alike() {
        let (axis, angle, by) = (DVec3::new(1.0, 2.0, -0.5), 0.8, DVec3::new(1.0, 2.0, 3.0));
        let rigid = Motion::rigid(DQuat::from_axis_angle(axis.normalize(), angle), by);
        let other = Motion::new(by, axis, angle, 1.0).unwrap();
        let x = DVec3::new(0.3, -4.0, 2.0);
        assert!(rigid.point(x).distance(other.point(x)) < 1e-14);
        assert_eq!(Motion::rigid(DQuat::IDENTITY, DVec3::ZERO), Motion::IDENTITY);
    }

    #[test]
    fn a_motion_takes_one_frame_to_another() {
        let turned = Motion::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 2.0, -0.5), 0.8, 1.0).unwrap();
        let frame =
            Motion::to_frame(turned.point(DVec3::ZERO), DVec3::AXES.map(|axis| turned.direction(axis)));
        assert_eq!(frame, turned);
    }

    #[test]
    fn wrong_motions_name_the_field() {
        let new = |axis, angle, scale| Motion::new(DVec3::ZERO, axis, angle, scale).unwrap_err();
        assert_eq!(new(DVec3::Z, 0.0, 0.0), ShapeError::NotPositive { field: "scale".into(), value: 0.0 });
        assert_eq!(new(DVec3::ZERO, 1.0, 1.0), ShapeError::ZeroLength { field: "rotate".into() });
        assert_eq!(new(DVec3::Z, f64::NAN, 1.0).field(), "rotate");
        assert_eq!(Motion::new(DVec3::ZERO, DVec3::ZERO, 0.0, 1.0).unwrap(), Motion::IDENTITY);
    }
}
