//! Spots that are read: a point, a surface, a part of one, a pixel.

use radiosity_geom::{DVec3, Ray, Rect};
use radiosity_scene::Camera;

use crate::rays::{Place, Rays};
use crate::spread::Spread;
use crate::walk::Vertex;

/// A place that is read. Coordinates are those that the scene is computed in: its middle is subtracted
/// ([`radiosity_scene::Scene::middle`]).
#[derive(Clone, Debug, PartialEq)]
pub enum Spot {
    /// Irradiance at a point along a unit normal; on a surface it belongs to the uppermost one on that side.
    Point {
        /// The point (scene length).
        position: DVec3,
        /// Unit normal along which it receives.
        normal: DVec3,
    },
    /// Mean irradiance over the part of a surface that nothing stands on, by its index in the scene.
    Surface(usize),
    /// Mean irradiance over a rectangle of a surface's parameters, as of [`Spot::Surface`].
    Cell {
        /// Index of the surface.
        surface: usize,
        /// The rectangle of its parameters.
        rect: Rect,
    },
    /// π times the mean radiance that arrives through a pixel.
    Pixel(Pixel),
}

/// A pixel of a picture, as a parallelogram in front of an eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    eye: DVec3,
    /// From the eye to the upper left corner.
    corner: DVec3,
    across: DVec3,
    down: DVec3,
}

impl Pixel {
    /// The pixel in a column from the left and a row from the top of a camera's picture.
    pub fn of(camera: &Camera, column: u32, row: u32) -> Self {
        let view = (camera.target - camera.eye).normalize();
        let right = view.cross(camera.up).normalize();
        let up = right.cross(view);
        // Half the height of the picture at the distance 1.
        let half = (0.5 * camera.fov).to_radians().tan();
        let side = 2.0 * half / f64::from(camera.height);
        let left = f64::from(column) - 0.5 * f64::from(camera.width);
        let top = 0.5 * f64::from(camera.height) - f64::from(row);
        let corner = view + side * (left * right + top * up);
        Self { eye: camera.eye, corner, across: side * right, down: -side * up }
    }

    /// The ray through a place of the pixel, from its upper left corner to the lower right one.
    fn ray(&self, [s, t]: [f64; 2]) -> Ray {
        Ray::new(self.eye, (self.corner + s * self.across + t * self.down).normalize())
    }
}

/// Starts of walks.
#[derive(Debug)]
pub(crate) enum Start<'a> {
    Point(Vertex),
    Spread { surface: usize, spread: Spread, rays: &'a Rays },
    Pixel(Pixel),
}

/// One start of a walk.
#[derive(Debug)]
pub(crate) enum Begin {
    /// At a vertex, with its weight in the mean.
    At(Vertex, f64),
    /// Against a ray.
    Against(Ray),
    /// On a part of a surface that something stands on; the weight that it would have.
    Covered(f64),
}

impl<'a> Start<'a> {
    pub(crate) fn of(spot: &Spot, rays: &'a Rays) -> Self {
        let spread = |surface: usize, rect| Self::Spread {
            surface,
            spread: Spread::over(rays.shape(surface), rect),
            rays,
        };
        match *spot {
            Spot::Point { position, normal } => {
                Self::Point(Vertex { point: rays.read_from(position, normal), normal })
            }
            Spot::Surface(surface) => spread(surface, Rect::FULL),
            Spot::Cell { surface, rect } => spread(surface, rect),
            Spot::Pixel(pixel) => Self::Pixel(pixel),
        }
    }

    /// The start of two draws.
    pub(crate) fn begin(&self, draws: [f64; 2]) -> Begin {
        match self {
            Self::Point(vertex) => Begin::At(*vertex, 1.0),
            Self::Pixel(pixel) => Begin::Against(pixel.ray(draws)),
            Self::Spread { surface, spread, rays } => {
                let Some(on) = spread.point(draws) else { return Begin::Covered(0.0) };
                let place = Place::on(*surface, &on);
                let weight = spread.weight(&on);
                match rays.is_bare(&place) {
                    true => {
                        Begin::At(Vertex { point: rays.left(&place, on.normal), normal: on.normal }, weight)
                    }
                    false => Begin::Covered(weight),
                }
            }
        }
    }
}
