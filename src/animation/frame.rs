//! The light of one frame.

use crate::scene::Scene;
use crate::solution::Solution;
use crate::solved::Solved;

/// The light of a frame.
#[derive(Debug)]
pub struct Frame {
    /// The still scene.
    pub scene: Scene,
    /// The polynomials of its light.
    pub solution: Solution,
    /// Estimated relative error of what was interpolated; None where the frame itself was solved.
    pub interpolated: Option<f64>,
    /// Estimated relative error that rays left in it, where they carried the pairs; else 0.
    pub rays: f64,
}

impl Frame {
    /// That of a frame that was solved itself.
    pub(super) fn of(solved: Solved) -> Self {
        let rays = solved.outcome.noise();
        Self { scene: solved.scene, solution: solved.outcome.solution, interpolated: None, rays }
    }
}
