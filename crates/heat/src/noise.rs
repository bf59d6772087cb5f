//! The noise that rays leave in a balance whose transfers they carried.
//!
//! A surface of area A sends, and is met by, rays in proportion to A. With e the error of mean irradiances of the n
//! elements, L2 over all relative to that of H, the irradiance of the surface is off by about
//!
//! ```text
//! e √(Σ H² A / Σ A) √(Σ A / (n A)) .
//! ```

use radiosity_solve::Outcome;

use super::figures::{SurfaceHeat, add_errors_of_irradiance};

/// Error that is told, over that of the mean surface. Measured: in a dented ball of 320 triangles nine tenths lie
/// within.
const TOLD: f64 = 2.0;

/// Error where so few rays were sent that halves of them tell none.
const UNKNOWN: f64 = 1.0;

/// The noise of rays.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noise {
    /// The part of e that is told.
    error: f64,
    /// n.
    elements: usize,
}

impl Noise {
    /// The noise of a balance; None where rules carry it.
    pub(super) fn of(outcome: &Outcome) -> Option<Self> {
        let error = outcome.sampling.as_ref()?.error.unwrap_or(UNKNOWN);
        Some(Self { error: TOLD * error, elements: outcome.solution.elements().list().len() })
    }

    /// Makes the errors of all surfaces those of this noise at the least.
    pub(super) fn add_to(self, surfaces: &mut [SurfaceHeat]) {
        let lit = |own: &&SurfaceHeat| own.has_level() && own.area > 0.0;
        let area: f64 = surfaces.iter().filter(lit).map(|own| own.area).sum();
        let power: f64 = surfaces.iter().filter(lit).map(|own| own.area * own.irradiance.powi(2)).sum();
        for own in surfaces.iter_mut().filter(|own| own.has_level() && own.area > 0.0) {
            let irradiance = self.error * (power / (self.elements as f64 * own.area)).sqrt();
            add_errors_of_irradiance(own, irradiance.min(UNKNOWN * (power / area).sqrt()));
        }
    }
}
