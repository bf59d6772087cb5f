//! The light of one frame.

use radiosity_geom::DVec3;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;

use crate::driver::FrameLight;
use crate::gather::Gather;
use crate::solution::Solution;
use crate::tolerances::AT_A_POINT;

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

    /// Irradiance per band at a point in the open, for the unit normal `normal`, as
    /// [`Solved::irradiance_at`](crate::solved::Solved::irradiance_at) has it of a still scene.
    pub fn irradiance_at(&self, position: DVec3, normal: DVec3) -> Vec<f64> {
        let gather = Gather::new(&self.solution, &self.visibility, AT_A_POINT);
        gather.at(&ReceiverPoint::free(position, normal))
    }
}
