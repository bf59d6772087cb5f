//! From where a picture is taken.

use radiosity_geom::DVec3;

use crate::scene::error::Fault;

/// A pinhole camera, valid by construction: it looks somewhere, and its up vector is not along the view.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// The pinhole.
    pub eye: DVec3,
    /// A point in the middle of the picture.
    pub target: DVec3,
    /// What points up in the picture; any length, not along the view.
    pub up: DVec3,
    /// Vertical angle of view in degrees, 0 < fov < 180.
    pub fov: f64,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
}

/// Pictures are at most this wide and high.
pub(super) const MAX_PIXELS: u32 = 16384;

impl Camera {
    /// Checks that the camera has a view.
    ///
    /// # Errors
    /// [`Fault::BadCamera`] if eye and target coincide or `up` lies along the view.
    pub(super) fn checked(self) -> Result<Self, Fault> {
        let view = (self.target - self.eye).try_normalize();
        let up = self.up.try_normalize();
        let problem = match (view, up) {
            (None, _) => "eye and target are the same point",
            (_, None) => "the up vector has no length",
            (Some(view), Some(up)) if view.cross(up).length() < 1e-9 => "the up vector lies along the view",
            _ => return Ok(self),
        };
        Err(Fault::BadCamera { problem })
    }
}
