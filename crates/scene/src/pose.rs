//! Where a rigid thing is, relative to where it rests: x ↦ R x + τ, R a rotation.

use radiosity_geom::{DQuat, DVec3, Motion};

/// A rigid motion: distances and the sense of turning stay, to rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose(Motion);

impl Pose {
    /// At rest.
    pub const REST: Self = Self(Motion::IDENTITY);

    /// Turned by the unit quaternion `rotation` about `center`, then moved by `shift` (scene length).
    ///
    /// Without a rotation and a shift it is [`Pose::REST`], to the bit.
    pub(super) fn about(center: DVec3, rotation: DQuat, shift: DVec3) -> Self {
        let turn = Motion::rigid(rotation, DVec3::ZERO);
        Self(Motion::rigid(rotation, center - turn.point(center) + shift))
    }

    /// Whether everything stays where it is, to the bit.
    pub fn is_rest(&self) -> bool {
        *self == Self::REST
    }

    /// The motion; its scale is 1.
    pub(crate) fn motion(&self) -> &Motion {
        &self.0
    }

    /// Where a point at rest is.
    pub fn point(&self, x: DVec3) -> DVec3 {
        self.0.point(x)
    }

    /// Where a difference of points at rest, or a normal, shows.
    pub fn vector(&self, d: DVec3) -> DVec3 {
        self.0.direction(d)
    }
}
