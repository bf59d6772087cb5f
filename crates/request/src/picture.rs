//! Pictures: their pixels, and the memory that these need.

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
