//! The case of a balance: its scene, what is known of each surface, and how it is solved.
//!
//! Rays that carry its pairs carry constants: their rows are positive and sum to 1 at the most, so that light that
//! surfaces of known flux reflect without loss settles. Polynomials by few rays make more of it than arrives: the
//! system of a soda shop did not converge in minutes.

use std::cell::OnceCell;

use radiosity_scene::Scene;
use radiosity_solve::{Direct, Options, Transport, TransportChoice};
use radiosity_work::ranks::Ranks;

use super::error::HeatError;
use super::forecast::Forecast;
use super::roles::Roles;

/// Rays for each surface, in all at least, and in all at the most, at [`USUAL_EPS`], where no number is given. Chosen:
/// ten thousand triangles take a gigabyte and some twenty seconds of one thread.
const RAYS_PER_SURFACE: f64 = 2_500.0;
const FEWEST_RAYS: f64 = 2e6;
const USUALLY_MOST: f64 = 8e6;

/// Accuracy of transfers for which these are the numbers.
const USUAL_EPS: f64 = 1e-4;

/// Part of these rays that is sent even where any accuracy would do.
const LEAST_PART: f64 = 0.125;

/// The scene of a balance with the backs that heat reaches, the roles of its surfaces, and the options of its light.
#[derive(Debug)]
pub(super) struct Case {
    pub(super) scene: Scene,
    pub(super) roles: Roles,
    /// The carrier of its pairs and their order are settled.
    pub(super) options: Options,
    /// The carrier, and the reason for it.
    pub(super) choice: TransportChoice,
}

impl Case {
    /// The case of a scene with its backs.
    ///
    /// # Errors
    /// Surfaces of which too little is known.
    pub(super) fn of(scene: Scene, wanted: &Options) -> Result<Self, HeatError> {
        let roles = Roles::of(&scene)?;
        let tolerance = wanted.tolerance.max(roles.rounding(&scene));
        let options = Options { direct: Direct::Projected, near_layers: true, tolerance, ..*wanted };
        let visibility = OnceCell::new();
        let see = || visibility.get_or_init(|| options.visibility(&scene));
        let choice = TransportChoice::of(&scene, &options, None, see);
        let transport = if choice.sampled { Transport::Sampled } else { Transport::Exact };
        let usual = || usual_rays(scene.surfaces.len(), options.shadow_eps);
        let rays = options.rays.or_else(|| choice.sampled.then(usual));
        let order = if choice.sampled { 0 } else { options.order };
        // A number of rays that is given is that of all surfaces.
        let rays_of_pairs = options.rays.is_none();
        let options = Options { transport, rays, rays_of_pairs, order, ..options };
        Ok(Self { scene, roles, options, choice })
    }

    /// Forecast of its memory.
    pub(super) fn forecast<'a>(&'a self, ranks: &'a Ranks) -> Forecast<'a> {
        Forecast::of(&self.scene, &self.roles, &self.options, ranks)
    }
}

/// Rays for the balance of so many surfaces to this accuracy.
fn usual_rays(surfaces: usize, eps: f64) -> u64 {
    let usual = (RAYS_PER_SURFACE * surfaces as f64).clamp(FEWEST_RAYS, USUALLY_MOST);
    (usual * (USUAL_EPS / eps).max(LEAST_PART)).ceil() as u64
}
