//! Options of view factors.

use radiosity_kernel::Accuracy;
use radiosity_visibility::Shadows;

use crate::driver::Transport;

/// Options of view factors: cuts, accuracies, shadows, what carries the pairs, memory and threads.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Cuts along u and v of surfaces that do not state their own; None chooses. The factors are those of
    /// whole surfaces; cuts make shadows more accurate where rules find them.
    pub subdivide: Option<usize>,
    /// Accuracy of the exchange of two elements.
    pub accuracy: Accuracy,
    /// Ways to find shadows between surfaces.
    pub shadows: Shadows,
    /// Carriers of the pairs.
    pub transport: Transport,
    /// Rays, where these carry the pairs; None: by the number of surfaces and the accuracy.
    pub rays: Option<u64>,
    /// Most bytes to use; rules, or a given number of rays, that need more are refused.
    pub memory: Option<u64>,
    /// Threads, 0 for all that a rank may use; the result does not depend on it.
    pub threads: usize,
}

impl Default for Options {
    /// Every pair to 1e-3 with its shadows by rules, or by rays where rules would take long.
    fn default() -> Self {
        Self {
            subdivide: None,
            accuracy: Accuracy { eps: 1e-3, shadow_eps: 1e-3 },
            shadows: Shadows::Auto,
            transport: Transport::Auto,
            rays: None,
            memory: None,
            threads: 0,
        }
    }
}

impl Options {
    /// The accuracies of pairs and their shadows.
    pub(super) fn block_accuracy(&self) -> Accuracy {
        let Accuracy { eps, shadow_eps } = self.accuracy;
        Accuracy { eps, shadow_eps: self.shadows.accuracy(eps, shadow_eps) }
    }
}
