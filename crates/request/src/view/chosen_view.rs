//! The view that is chosen of a scene without a camera: from a corner of a room towards the far one, or of
//! anything else three quarters from outside and above.
//!
//! Of several eyes the one is taken whose picture shows most: for a room the sum over rays of their lengths to
//! the fronts they meet, which is little in corners that furniture fills, for a thing the number of fronts.

use radiosity_geom::{Aabb, DVec3, Ray, Rect};
use radiosity_reading::pictures::pinhole::Pinhole;
use radiosity_scene::{Camera, Scene};
use radiosity_visibility::Visibility;

/// Distances of the eye from the middle of a room, over its size: near a corner, and further in where something
/// stands there. Chosen.
const INSETS: [f64; 3] = [0.43, 0.33, 0.2];

/// Heights of eye and target over the floor, over the height of the room: 1.6 m and 1.1 m of 2.7 m.
const EYE_HEIGHT: f64 = 0.6;
const TARGET_HEIGHT: f64 = 0.4;

/// Angles of view (degrees) inside and outside. Chosen: two walls of a room; a thing and a little around it.
const INSIDE: f64 = 70.0;
const OUTSIDE: f64 = 40.0;

/// Slope of the view onto a thing, height over distance. Chosen.
const SLOPE: f64 = 0.45;

/// Share of directions in which an eye within a room meets a front. Chosen: one wall may be missing, and a thing on
/// a floor is none.
const ENCLOSED: f64 = 0.75;

/// Rays along each side of a picture that is tried. Chosen.
const ACROSS: u32 = 12;

/// The four directions to the corners of a floor plan, the first of which is taken where all show as much.
const CORNERS: [[f64; 2]; 4] = [[1.0, -1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// The camera of the view, in the coordinates of the scene's surfaces; up is the axis that is nearest to `up`.
pub(super) fn chosen_view(scene: &Scene, up: DVec3) -> Camera {
    let shapes = scene.surfaces.iter().map(|surface| &surface.shape);
    let bounds = shapes.fold(Aabb::EMPTY, |bounds, shape| bounds.union(shape.bounds(&Rect::FULL)));
    if scene.surfaces.is_empty() {
        return Camera::new(DVec3::new(1.0, -1.0, 1.0), DVec3::ZERO);
    }
    let visibility = Visibility::open(scene);
    let sight = Sight { visibility, bounds, axes: axes(up), middle: scene.middle };
    let inside: Vec<Camera> = INSETS.into_iter().flat_map(|inset| sight.inside(inset)).collect();
    if inside.iter().any(|camera| sight.enclosed(camera.eye) >= ENCLOSED) {
        return best(inside, |camera| sight.seen(camera).sum());
    }
    best(sight.outside(), |camera| sight.seen(camera).count() as f64)
}

/// A right-handed frame of axes, the last of which is nearest to `up`.
fn axes(up: DVec3) -> [DVec3; 3] {
    let parts = up.abs().to_array();
    let last = (0..3).max_by(|a, b| parts[*a].total_cmp(&parts[*b])).unwrap_or(2);
    let axis = |index: usize| DVec3::AXES[index % 3];
    let sign = if up.to_array()[last] < 0.0 { -1.0 } else { 1.0 };
    [axis(last + 1), sign * axis(last + 2), sign * axis(last)]
}

/// The first of the cameras whose worth is greatest.
fn best(cameras: Vec<Camera>, worth: impl Fn(&Camera) -> f64) -> Camera {
    let worths: Vec<f64> = cameras.iter().map(worth).collect();
    let greatest = worths.iter().copied().fold(0.0, f64::max);
    let first = worths.iter().position(|worth| *worth == greatest).unwrap_or(0);
    cameras.into_iter().nth(first).expect("views are tried")
}

/// A scene as eyes see it.
struct Sight {
    visibility: Visibility,
    bounds: Aabb,
    /// Two directions along the floor, and up.
    axes: [DVec3; 3],
    /// Vector to be added to coordinates that are told (scene length).
    middle: DVec3,
}

impl Sight {
    /// Cameras near the corners of a room, at eye height, that look towards the far corners.
    fn inside(&self, inset: f64) -> [Camera; 4] {
        let (middle, size) = (self.bounds.center(), self.bounds.max - self.bounds.min);
        let at = |[x, y]: [f64; 2], height: f64| {
            middle + size * self.along(DVec3::new(inset * x, inset * y, height - 0.5))
        };
        CORNERS.map(|[x, y]| self.camera(at([x, y], EYE_HEIGHT), at([-x, -y], TARGET_HEIGHT), INSIDE))
    }

    /// Cameras around a thing, a little above it, that have its bounding sphere in view.
    fn outside(&self) -> Vec<Camera> {
        let middle = self.bounds.center();
        let radius = 0.5 * self.bounds.diagonal().max(f64::MIN_POSITIVE);
        let distance = radius / (0.5 * OUTSIDE.to_radians()).sin();
        // Corners at three quarters: nearer to one side than to the other.
        let direction = |[x, y]: [f64; 2]| self.along(DVec3::new(0.5 * x, 0.85 * y, SLOPE)).normalize();
        let eye = |corner| middle + distance * direction(corner);
        CORNERS.into_iter().map(|corner| self.camera(eye(corner), middle, OUTSIDE)).collect()
    }

    /// The vector of these parts along the axes.
    fn along(&self, parts: DVec3) -> DVec3 {
        let [x, y, z] = self.axes;
        parts.x * x + parts.y * y + parts.z * z
    }

    /// A camera whose numbers, in the coordinates of the file, are short.
    fn camera(&self, eye: DVec3, target: DVec3, fov: f64) -> Camera {
        let [eye, target] = [eye, target].map(|point| self.rounded(point));
        Camera { fov, up: self.axes[2], ..Camera::new(eye, target) }
    }

    /// A point rounded to a power of ten between a thousandth and a hundredth of the scene's diagonal.
    fn rounded(&self, point: DVec3) -> DVec3 {
        let step = 10f64.powf((1e-3 * self.bounds.diagonal()).log10().ceil());
        if !step.is_normal() {
            return point;
        }
        let decimals = (-step.log10()).max(0.0).round() as usize;
        let rounded = |x: f64| -> f64 {
            // Written and read, it is the number that its digits say.
            let text = format!("{:.decimals$}", (x / step).round() * step);
            text.parse().unwrap_or(x)
        };
        let told = (point + self.middle).to_array().map(rounded);
        DVec3::from_array(told) - self.middle
    }

    /// Share of the directions to the neighbours of a cube in which a front is met.
    fn enclosed(&self, eye: DVec3) -> f64 {
        let steps = || [-1.0, 0.0, 1.0].into_iter();
        let all = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| DVec3::new(x, y, z))));
        let directions: Vec<DVec3> = all.filter(|direction| *direction != DVec3::ZERO).collect();
        let meets = |direction: &&DVec3| self.length(&Ray::new(eye, **direction)).is_some();
        directions.iter().filter(meets).count() as f64 / directions.len() as f64
    }

    /// Lengths of rays through a picture to the fronts they meet.
    fn seen(&self, camera: &Camera) -> impl Iterator<Item = f64> {
        let [width, height] = [camera.width, camera.height].map(f64::from);
        let pinhole = Pinhole::new(camera);
        let part = |k: u32| (f64::from(k) + 0.5) / f64::from(ACROSS);
        let places = (0..ACROSS * ACROSS).map(move |k| [part(k % ACROSS), part(k / ACROSS)]);
        places.filter_map(move |[x, y]| self.length(&pinhole.ray(width * x, height * y)))
    }

    /// Length of a ray to the front that it meets first, if that is a front.
    fn length(&self, ray: &Ray) -> Option<f64> {
        let met = self.visibility.nearest(ray)?;
        met.front.then(|| met.hit.t * ray.direction.length())
    }
}
