//! The rays of a pinhole camera.

use radiosity_geom::{DVec3, Ray};
use radiosity_scene::Camera;

/// A camera ready to cast rays.
#[derive(Clone, Copy, Debug)]
pub struct Pinhole {
    eye: DVec3,
    /// Direction through the left upper corner of the picture.
    corner: DVec3,
    /// Steps by one pixel to the right and down.
    right: DVec3,
    down: DVec3,
}

impl Pinhole {
    /// The view of `camera`.
    pub fn new(camera: &Camera) -> Self {
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let down = forward.cross(right);
        let half_height = f64::tan(0.5 * camera.fov.to_radians());
        let pixel = 2.0 * half_height / f64::from(camera.height);
        let half_width = 0.5 * pixel * f64::from(camera.width);
        Self {
            eye: camera.eye,
            corner: forward - right * half_width - down * half_height,
            right: right * pixel,
            down: down * pixel,
        }
    }

    /// The ray through the point (x, y) of the picture, in pixels from its left upper corner.
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        let direction = self.corner + self.right * x + self.down * y;
        Ray { origin: self.eye, direction, range: [0.0, f64::INFINITY] }
    }

    /// Rays through `samples × samples` points of a regular grid over a pixel, counted from the left upper
    /// one.
    pub(super) fn rays(&self, [column, row]: [u32; 2], samples: u32) -> impl Iterator<Item = Ray> {
        let offset = move |k: u32| (f64::from(k) + 0.5) / f64::from(samples);
        (0..samples * samples).map(move |k| {
            self.ray(f64::from(column) + offset(k % samples), f64::from(row) + offset(k / samples))
        })
    }
}
