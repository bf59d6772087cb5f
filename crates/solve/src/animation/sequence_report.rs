//! Cost and error of the moments that were solved.

use radiosity_kernel::WorstError;
use radiosity_scene::Scene;
use radiosity_transport::RayCounts;

use crate::driver::{FrameLight, Stages};

/// Cost and error of the moments that were solved, all together.
#[derive(Clone, Debug, Default)]
pub struct SequenceReport {
    /// Moments that were solved.
    pub moments: usize,
    /// Rays that were sent between elements.
    pub rays: RayCounts,
    /// Wall time of all stages.
    pub seconds: Stages,
    /// Moments at which the solver did not converge.
    pub unconverged: Unconverged,
    /// Moments at which transfers miss what was asked of them.
    pub missing: usize,
    /// The worst of these transfers.
    pub worst: Option<WorstTransfer>,
    /// Bound of the relative error, the largest, that is left unsolved where the difference of two moments was
    /// solved for; 0 where all moments were solved whole.
    pub unsolved: f64,
    /// Estimated relative error that rays left, the largest; 0 where none carried the pairs.
    pub noise: f64,
}

/// Moments at which the solver did not converge.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unconverged {
    /// Their number.
    pub moments: usize,
    /// Their largest relative residual.
    pub residual: f64,
}

/// A transfer that misses what was asked of it.
#[derive(Clone, Debug)]
pub struct WorstTransfer {
    /// Its error.
    pub error: WorstError,
    /// Names of its surfaces.
    pub surfaces: [String; 2],
}

impl SequenceReport {
    /// Adds the solution of the scene of a moment, for which these rays were sent.
    pub(super) fn take(&mut self, scene: &Scene, light: &FrameLight, rays: RayCounts) {
        self.moments += 1;
        self.seconds += light.seconds;
        self.rays.traced += rays.traced;
        self.rays.recalled += rays.recalled;
        if !light.converged {
            self.unconverged.moments += 1;
            self.unconverged.residual = self.unconverged.residual.max(light.residual);
        }
        self.noise = self.noise.max(light.noise());
        // What exact pairs miss beside rays is a part of their error.
        let miss = light.worst_error.filter(|miss| miss.is_real() && light.sampling.is_none());
        if let Some(miss) = miss {
            self.missing += 1;
            let excess = |error: &WorstError| error.error / error.asked;
            if self.worst.as_ref().is_none_or(|worst| excess(&miss) > excess(&worst.error)) {
                let list = light.solution.elements().list();
                let name = |element: usize| scene.surfaces[list[element].surface].name.clone();
                self.worst = Some(WorstTransfer { error: miss, surfaces: miss.pair.map(name) });
            }
        }
    }
}
