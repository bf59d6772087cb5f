//! Poses: the place of a rigid thing relative to its place at rest, x ↦ R x + τ with a rotation R.

use radiosity_geom::{DQuat, DVec3, Motion};

/// A rigid motion, which keeps distances and handedness to rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose(Motion);

impl Pose {
    /// The pose at rest: the identity.
    pub const REST: Self = Self(Motion::IDENTITY);

    /// The pose turned by the unit quaternion `rotation` about `center`, then moved by `shift` (scene
    /// length).
    ///
    /// Without a rotation and a shift it is [`Pose::REST`], to the bit.
    pub(super) fn about(center: DVec3, rotation: DQuat, shift: DVec3) -> Self {
        let turn = Motion::rigid(rotation, DVec3::ZERO);
        Self(Motion::rigid(rotation, center - turn.point(center) + shift))
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

    /// Direction in this pose of a difference of points at rest, or of a normal.
    pub fn vector(&self, d: DVec3) -> DVec3 {
        self.0.direction(d)
    }
}
