//! Light by the number of its reflections: Neumann's series term by term.
//!
//! ```text
//! t_1 = G ρ d (or g, where direct light is split off) ,     t_{k+1} = G ρ t_k
//! ```

use radiosity_core::norm;

use super::{Coefficients, System};

impl System<'_> {
    /// The coefficients of light whose `next` reflection is left out: the irradiance that it would bring.
    pub(super) fn truncated(&self, irradiance: Vec<f64>, direct: Vec<f64>, next: &[f64]) -> Coefficients {
        let residual = self.relative(norm(&self.reflected(next)));
        Coefficients::of_irradiance(self.elements, self.coating, irradiance, direct, residual)
    }

    /// Irradiance that was reflected exactly once, for the direct irradiance.
    pub(super) fn reflected_once(&self, direct: &[f64]) -> Vec<f64> {
        if self.is_split { self.first.clone() } else { self.reflected_again(direct) }
    }

    /// G ρ h: irradiance that was reflected once more.
    pub(super) fn reflected_again(&self, irradiance: &[f64]) -> Vec<f64> {
        self.blocks.apply(&self.reflected(irradiance))
    }

    /// ρ h: radiosity that reflects the irradiance h.
    fn reflected(&self, irradiance: &[f64]) -> Vec<f64> {
        self.coating.reflected(self.blocks.starts(), irradiance)
    }
}
