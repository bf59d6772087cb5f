//! The rays of a pinhole camera.

use radiosity_geom::{DVec3, Ray};
use radiosity_scene::Camera;

use super::pixel_grid::PixelGrid;

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

    /// Width of a pixel at the distance of a point from the eye (scene length).
    pub fn footprint(&self, point: DVec3) -> f64 {
        self.eye.distance(point) * self.right.length()
    }

    /// The place of a point in the picture, in pixels from its left upper corner; None behind the eye.
    pub fn place(&self, point: DVec3) -> Option<[f64; 2]> {
        // point − eye = s (corner + x right + y down), by Cramer's rule.
        let to = point - self.eye;
        let triple = |a: DVec3, b: DVec3, c: DVec3| a.dot(b.cross(c));
        let depth = triple(to, self.right, self.down) / triple(self.corner, self.right, self.down);
        let across = triple(self.corner, to, self.down) / triple(self.corner, self.right, self.down);
        let below = triple(self.corner, self.right, to) / triple(self.corner, self.right, self.down);
        (depth > 0.0).then(|| [across / depth, below / depth])
    }

    /// Rays through the points of a grid over a pixel.
    pub fn rays(&self, [column, row]: [u32; 2], grid: &PixelGrid) -> impl Iterator<Item = Ray> {
        grid.points().iter().map(move |[x, y]| self.ray(f64::from(column) + x, f64::from(row) + y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_along_a_ray_have_its_place() {
        let camera = Camera {
            eye: DVec3::new(3.0, -2.0, 1.0),
            target: DVec3::new(0.5, 0.2, 0.7),
            up: DVec3::Z,
            fov: 50.0,
            width: 320,
            height: 200,
        };
        let view = Pinhole::new(&camera);
        for wanted in [[0.0, 0.0], [160.0, 100.0], [317.5, 12.25]] {
            let ray = view.ray(wanted[0], wanted[1]);
            let place = view.place(ray.at(3.7)).expect("it lies before the eye");
            assert!((place[0] - wanted[0]).abs() + (place[1] - wanted[1]).abs() < 1e-9, "{place:?}");
            assert_eq!(view.place(ray.at(-0.1)), None);
        }
    }
}
