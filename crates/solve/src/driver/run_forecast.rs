//! The forecast of a solution, for people who choose how to solve: its elements are cut, and nothing else is made.

use radiosity_scene::Scene;
use radiosity_work::ranks::Ranks;

use super::decisions::AssemblyPlan;
use super::failure::Failure;
use super::forecast::seconds_of_pairs;
use super::options::Options;
use super::ready::{elements, require_diffuse};

/// The forecast of a solution, by counts of its elements, pairs and rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunForecast {
    /// Rays that carry the light between surfaces; None where rules do.
    pub rays: Option<u64>,
    /// Elements that its surfaces are cut into.
    pub elements: usize,
    /// Unknowns of each band.
    pub unknowns: usize,
    /// The forecast of its transfers: seconds of [`radiosity_work::FORECAST_THREADS`] threads of the machine of the
    /// prices, which [`radiosity_work::Machine::seconds`] makes those of this one.
    pub transfers: f64,
    /// Bytes that it takes at the most, on each rank.
    pub bytes: u64,
}

impl RunForecast {
    /// The forecast of the solution of `scene` with these options.
    ///
    /// # Errors
    /// Options that the scene does not allow, or a scene that cannot be cut into elements.
    pub fn of(scene: &Scene, options: &Options, ranks: &Ranks) -> Result<Self, Failure> {
        options.in_threads(ranks, || {
            require_diffuse(scene, options)?;
            let decisions = AssemblyPlan::default().decided(scene, options, None);
            let own = elements(scene, &decisions, None)?;
            Ok(Self {
                rays: decisions.rays,
                elements: own.list().len(),
                unknowns: own.coefficients(),
                transfers: seconds_of_pairs(scene, &own, &decisions.visibility, decisions.rays),
                bytes: decisions.peak_memory(scene, options, ranks),
            })
        })?
    }
}
