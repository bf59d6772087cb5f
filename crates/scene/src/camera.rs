//! Cameras: viewpoint, direction and size of a picture.

use radiosity_geom::{DVec3, PARALLEL_DIRECTIONS};

use crate::{
    fault::{Fault, FaultKind},
    ranges::{check_fov, check_pixels},
};

/// A pinhole camera. A scene's camera has a view direction, and its up vector is not along it.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Position of the pinhole (scene length).
    pub eye: DVec3,
    /// A point in the middle of the picture (scene length).
    pub target: DVec3,
    /// The direction that is up in the picture; any length, not along the view.
    pub up: DVec3,
    /// Vertical angle of view in degrees, 0 < fov < 180.
    pub fov: f64,
    /// Pixels across, 1 to 16384.
    pub width: u32,
    /// Pixels down, 1 to 16384.
    pub height: u32,
}

impl Camera {
    /// A camera that looks from `eye` to `target`; up is +z, the angle of view 40 degrees, the picture 512 ×
    /// 512 pixels.
    ///
    /// Change the rest: `Camera { fov: 60.0, ..Camera::new(eye, target) }`. A scene checks its camera.
    pub fn new(eye: DVec3, target: DVec3) -> Self {
        Self { eye, target, up: DVec3::Z, fov: 40.0, width: 512, height: 512 }
    }

    /// The camera after `middle` was subtracted from all coordinates.
    pub fn about(self, middle: DVec3) -> Self {
        Self { eye: self.eye - middle, target: self.target - middle, ..self }
    }

    /// Checks that the camera has a view.
    ///
    /// # Errors
    /// [`FaultKind::NotFinite`] or [`FaultKind::OutOfRange`] for a number; [`FaultKind::NoDirection`] if eye and target
    /// coincide or `up` lies along the view.
    pub fn checked(self) -> Result<Self, Fault> {
        let numbers = [self.eye, self.target, self.up].into_iter().flat_map(|point| point.to_array());
        if let Some(value) = numbers.chain([self.fov]).find(|value| !value.is_finite()) {
            return Err(Fault::not_finite(value));
        }
        check_fov(self.fov)?;
        [self.width, self.height].into_iter().try_for_each(|pixels| check_pixels(pixels as usize))?;
        let view = (self.target - self.eye).try_normalize();
        let up = self.up.try_normalize();
        let problem = match (view, up) {
            (None, _) => "eye and target are the same point",
            (_, None) => "the up vector has no length",
            (Some(view), Some(up)) if view.cross(up).length() < PARALLEL_DIRECTIONS => {
                "the up vector lies along the view"
            }
            _ => return Ok(self),
        };
        Err(Fault::new(FaultKind::NoDirection, problem, "move the eye, the target or the up vector"))
    }
}
