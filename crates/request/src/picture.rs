//! Pictures: the camera that takes one, and the memory that it needs.

use radiosity_geom::{Aabb, DVec3, Ray, Rect};
use radiosity_scene::{Camera, Scene};
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, words};

use super::memory;
use super::ranges::Bytes;
use super::refusal::Refusal;

/// Camera rays along each side of a pixel unless told otherwise. Chosen.
pub const SAMPLES: u32 = 3;

/// Bytes of a pixel beside its bands, and of each band. Measured: 130 for three bands.
const PIXEL: u64 = 60;
const BAND: u64 = 24;

/// Bytes more of a pixel that is worked on, and how many are at once. Measured: 330 for three bands.
const IN_WORK: u64 = 330;
const AT_ONCE: u64 = 1 << 20;

/// A picture was asked of a scene without a camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{origin}: there is no camera to take a picture with")]
pub struct NoCamera {
    /// The scene as named in messages.
    pub origin: String,
    /// A camera that sees the scene, as one would write it.
    pub proposal: String,
}

impl NoCamera {
    /// Cure of the missing camera, for people: the proposal as text.
    pub fn cure(&self) -> String {
        format!("add a [camera] with eye and target to the scene, such as {}", self.proposal)
    }
}

/// The scene's camera with so many pixels across and down, or with its own.
///
/// # Errors
/// A scene without one.
pub fn camera(size: Option<[u32; 2]>, scene: &Scene) -> Result<Camera, NoCamera> {
    let no_camera = || NoCamera { origin: scene.origin.clone(), proposal: proposal(scene) };
    Ok(sized(scene.camera.clone().ok_or_else(no_camera)?, size))
}

/// The camera with the pixels that were asked for.
pub fn sized(camera: Camera, size: Option<[u32; 2]>) -> Camera {
    match size {
        Some([width, height]) => Camera { width, height, ..camera },
        None => camera,
    }
}

/// Pixels of a camera's picture.
pub fn pixels(camera: &Camera) -> u64 {
    u64::from(camera.width) * u64::from(camera.height)
}

/// Refuses a picture for which there is no room in the memory that is `allowed`, or usable.
///
/// # Errors
/// Where there is no room.
pub fn require_pixels(
    camera: &Camera,
    scene: &Scene,
    allowed: Option<Bytes>,
    ranks: &Ranks,
) -> Result<(), Refusal> {
    let pixels = pixels(camera);
    let needed = pixels * (PIXEL + BAND * scene.bands.len() as u64) + pixels.min(AT_ONCE) * IN_WORK;
    memory::require(needed, allowed, "the pixels", words("ask for fewer with ") + option("size"), ranks)
}

/// A camera for a scene without one, in one line: inside what looks like a room, outside of anything else.
///
/// A scene looks like a room if rays from its middle along all axes, in both directions, meet a surface.
fn proposal(scene: &Scene) -> String {
    let shapes = || scene.surfaces.iter().map(|surface| &surface.shape);
    let bounds = shapes().fold(Aabb::EMPTY, |bounds, shape| bounds.union(shape.bounds(&Rect::FULL)));
    let (middle, size) = (bounds.center(), bounds.max - bounds.min);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let meets =
        |direction: DVec3| shapes().any(|shape| shape.intersect(&Ray::new(middle, direction)).is_some());
    let room = axes.into_iter().all(|axis| meets(axis) && meets(-axis));
    let (eye, fov) = if room {
        (middle + size * DVec3::new(0.3, -0.45, 0.1), 75)
    } else {
        (middle + bounds.diagonal() * DVec3::new(0.5, -1.2, 0.5), 50)
    };
    // Rounded to a power of ten between a thousandth and a hundredth of the scene's diagonal.
    let step = 10f64.powf((1e-3 * bounds.diagonal()).log10().ceil());
    let decimals = (-step.log10()).max(0.0).round() as usize;
    let point = |p: DVec3| {
        let [x, y, z] = (p + scene.middle).to_array().map(|x| (x / step).round() * step + 0.0);
        format!("[{x:.decimals$}, {y:.decimals$}, {z:.decimals$}]")
    };
    format!("[camera] eye = {}, target = {}, up = [0, 0, 1], fov = {fov}", point(eye), point(middle))
}
