//! Cost and error of the moments that were solved.

use radiosity_kernel::WorstError;
use radiosity_scene::Scene;
use radiosity_transport::RayCounts;

use crate::driver::Outcome;

/// Cost and error of the moments that were solved, all together.
#[derive(Clone, Debug, Default)]
pub struct SequenceReport {
    /// Moments that were solved.
    pub moments: usize,
    /// Rays that were sent between elements.
    pub rays: RayCounts,
    /// Moments at which the solver did not converge, and their largest relative residual.
    pub unconverged: (usize, f64),
    /// Moments at which transfers miss what was asked of them.
    pub missing: usize,
    /// The worst of these transfers, with the names of its surfaces.
    pub worst: Option<(WorstError, [String; 2])>,
    /// Estimated relative error that rays left, the largest; 0 where none carried the pairs.
    pub noise: f64,
}

impl SequenceReport {
    /// Adds the solution of the scene of a moment, for which these rays were sent.
    pub(super) fn take(&mut self, scene: &Scene, outcome: &Outcome, rays: RayCounts) {
        self.moments += 1;
        self.rays.traced += rays.traced;
        self.rays.recalled += rays.recalled;
        if !outcome.converged {
            self.unconverged = (self.unconverged.0 + 1, self.unconverged.1.max(outcome.residual));
        }
        self.noise = self.noise.max(outcome.noise());
        // What exact pairs miss beside rays is a part of their error.
        let miss = outcome.worst_error.filter(|miss| miss.is_real() && outcome.sampling.is_none());
        if let Some(miss) = miss {
            self.missing += 1;
            if self
                .worst
                .as_ref()
                .is_none_or(|(worst, _)| miss.error / miss.asked > worst.error / worst.asked)
            {
                let list = outcome.solution.elements().list();
                let name = |element: usize| scene.surfaces[list[element].surface].name.clone();
                self.worst = Some((miss, miss.pair.map(name)));
            }
        }
    }
}
