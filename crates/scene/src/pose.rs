//! Poses: the place of a rigid thing relative to its place at rest, x ↦ R x + τ with a rotation R.

use radiosity_geom::{DQuat, DVec3, Motion};

use crate::{fault::Fault, ranges::check_number};

/// Largest difference from 1 of the length of a quaternion that is taken for a rotation: more than single
/// precision rounds.
const ROUNDED: f64 = 1e-6;

/// A rigid motion, which keeps distances and handedness to rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose(Motion);

impl Pose {
    /// The pose at rest: the identity.
    pub const REST: Self = Self(Motion::IDENTITY);

    /// The pose turned by the unit quaternion `rotation` about `center`, then moved by `shift` (scene
    /// length).
    ///
    /// # Errors
    /// [`FaultKind::OutOfRange`](crate::FaultKind::OutOfRange) for a quaternion that is not of length 1 to
    /// 1e-6; a number that is not finite or out of range.
    pub fn rigid(center: DVec3, rotation: DQuat, shift: DVec3) -> Result<Self, Fault> {
        let numbers = center.to_array().into_iter().chain(shift.to_array()).chain(rotation.to_array());
        numbers.into_iter().try_for_each(check_number)?;
        let length = rotation.length();
        if (length - 1.0).abs() > ROUNDED {
            let fault = Fault::out_of_range("the length of the quaternion", length, "1, to 1e-6");
            return Err(fault.cured("give a unit quaternion, its vector times the sine of half the angle"));
        }
        Ok(Self::turned(center, rotation.normalize(), shift))
    }

    /// The pose turned by the unit quaternion `rotation` about `center`, then moved by `shift`.
    ///
    /// Without a rotation and a shift it is [`Pose::REST`], to the bit.
    pub(super) fn turned(center: DVec3, rotation: DQuat, shift: DVec3) -> Self {
        let turn = Motion::rigid(rotation, DVec3::ZERO);
        Self(Motion::rigid(rotation, center - turn.point(center) + shift))
    }

    /// The pose after `middle` was subtracted from all coordinates, as a scene does with its own
    /// ([`Scene::middle`](crate::Scene::middle)).
    #[must_use]
    pub fn about(self, middle: DVec3) -> Self {
        // Of a translation this is nothing, to the bit.
        let by = self.vector(middle) - middle;
        Self(self.0.then(&Motion::rigid(DQuat::IDENTITY, by)))
    }

    /// Whether the pose is [`Pose::REST`], to the bit.
    pub fn is_rest(&self) -> bool {
        *self == Self::REST
    }

    /// The motion; its scale is 1.
    pub(crate) fn motion(&self) -> &Motion {
        &self.0
    }

    /// Position in this pose of the point `x` at rest (scene length).
    pub fn point(&self, x: DVec3) -> DVec3 {
        self.0.point(x)
    }

    /// Position at rest of the point that is at `x` in this pose (scene length).
    pub fn point_back(&self, x: DVec3) -> DVec3 {
        self.0.point_back(x)
    }

    /// Direction in this pose of a difference of points at rest, or of a normal.
    pub fn vector(&self, d: DVec3) -> DVec3 {
        self.0.direction(d)
    }
}
