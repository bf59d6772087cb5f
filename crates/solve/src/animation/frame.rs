//! The light of one frame.

use radiosity_scene::Scene;
use radiosity_visibility::Visibility;

use crate::driver::FrameLight;
use crate::solution::Solution;

/// The light of a frame.
#[derive(Debug)]
pub struct Frame {
    /// The still scene.
    pub scene: Scene,
    /// The surfaces of the scene as obstacles, with the shadows it is solved with.
    pub visibility: Visibility,
    /// The polynomials of its light.
    pub solution: Solution,
    /// Estimated relative error of what was interpolated, or its bound where blocks are sums of series or only
    /// the difference from another frame was solved for; None where the frame itself was solved, by
    /// integrals.
    pub interpolated: Option<f64>,
    /// Estimated relative error that rays left in it, where they carried the pairs; else 0.
    pub rays: f64,
}

impl Frame {
    /// The frame of a scene that was solved itself.
    pub(super) fn of(scene: Scene, visibility: Visibility, light: FrameLight) -> Self {
        let rays = light.noise();
        Self { scene, visibility, solution: light.solution, interpolated: None, rays }
    }
}
