//! Which way is up: glTF has +y for it.

use std::f64::consts::FRAC_PI_2;

use glam::{DQuat, DVec3};
use radiosity_scene::Camera;

/// The turn that brings the scene's up to +y. Up is the axis nearest to that of the camera, and +z without a
/// camera, as cameras have it that state none.
pub(super) fn turn(camera: Option<&Camera>) -> DQuat {
    let up = camera.map_or(DVec3::Z, |camera| camera.up);
    let (x, y, z) = (up.x.abs(), up.y.abs(), up.z.abs());
    if y >= x && y >= z {
        return if up.y >= 0.0 { DQuat::IDENTITY } else { DQuat::from_rotation_x(2.0 * FRAC_PI_2) };
    }
    if z >= x {
        return DQuat::from_rotation_x(-FRAC_PI_2 * up.z.signum());
    }
    DQuat::from_rotation_z(FRAC_PI_2 * up.x.signum())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_axis_comes_up() {
        for up in [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y, DVec3::Z, -DVec3::Z] {
            let camera = Camera { up, ..Camera::new(DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0)) };
            assert!((turn(Some(&camera)) * up).distance(DVec3::Y) < 1e-15, "{up}");
        }
        assert!((turn(None) * DVec3::Z).distance(DVec3::Y) < 1e-15);
    }
}
