//! Materials: reflectance ρ and emission, per band.

use std::sync::Arc;

use crate::scene::{error::Fault, pattern::Pattern, ranges::check_range};

/// A Lambertian material. [`Material::new`] checks the ranges; scenes hold only checked ones.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Material {
    /// Reflectance ρ of each band, 0 ≤ ρ < 1; its mean over the parameters where it is patterned.
    pub reflectance: Vec<f64>,
    /// Emitted exitance of each band, W m⁻², ≥ 0; its mean over the parameters where it is patterned.
    pub emission: Vec<f64>,
    /// Diffuse transmittance τ of each band, the part of what arrives on the other side that leaves here; 0 ≤ τ, ρ + τ < 1.
    pub transmittance: Vec<f64>,
    /// How ρ varies over a surface.
    pub reflectance_pattern: Option<Arc<Pattern>>,
    /// How the emitted exitance varies over a surface.
    pub emission_pattern: Option<Arc<Pattern>>,
}

impl Material {
    /// A material of as many bands as `reflectance` and `emission` have entries.
    ///
    /// `reflectance`: 0 ≤ ρ < 1. `emission`: exitance, W m⁻², ≥ 0 and finite.
    ///
    /// # Errors
    /// [`Fault::OutOfRange`] or [`Fault::NotFinite`] for the first number that is wrong, [`Fault::WrongCount`] if the
    /// lengths differ.
    pub fn new(reflectance: Vec<f64>, emission: Vec<f64>) -> Result<Self, Fault> {
        let bands = reflectance.len();
        let material = Material { reflectance, emission, ..Material::black(bands) };
        material.check(bands)?;
        Ok(material)
    }

    /// Checks that there is a number in range for each of `bands` bands.
    pub(super) fn check(&self, bands: usize) -> Result<(), Fault> {
        check_count("the reflectance", &self.reflectance, bands)?;
        check_count("the emission", &self.emission, bands)?;
        self.reflectance.iter().try_for_each(|&rho| check_reflectance(rho))?;
        self.emission.iter().try_for_each(|&exitance| check_emission(exitance))
    }

    /// The material that neither reflects nor emits.
    pub fn black(bands: usize) -> Self {
        Material {
            reflectance: vec![0.0; bands],
            emission: vec![0.0; bands],
            transmittance: vec![0.0; bands],
            reflectance_pattern: None,
            emission_pattern: None,
        }
    }

    /// Whether it emits in any band.
    pub fn emits(&self) -> bool {
        self.emission.iter().any(|&exitance| exitance != 0.0)
    }

    /// Whether any light can leave it: it emits or reflects in some band.
    pub fn sends(&self) -> bool {
        self.emits() || self.reflectance.iter().chain(&self.transmittance).any(|&rho| rho > 0.0)
    }
}

/// As many numbers as bands.
pub(super) fn check_count(what: &'static str, numbers: &[f64], bands: usize) -> Result<(), Fault> {
    if numbers.len() == bands {
        return Ok(());
    }
    let expected = match bands {
        1 => "one number, as there is one band".to_owned(),
        _ => format!("{bands} numbers, one per band"),
    };
    Err(Fault::WrongCount { what, expected, found: numbers.len() })
}

/// 0 ≤ ρ < 1.
pub(super) fn check_reflectance(rho: f64) -> Result<(), Fault> {
    check_range(rho, (0.0..1.0).contains(&rho), "the reflectance", "0 ≤ ρ < 1")
}

/// Emission ≥ 0.
pub(super) fn check_emission(exitance: f64) -> Result<(), Fault> {
    check_range(exitance, exitance >= 0.0, "the emission", "emission ≥ 0")
}

/// Flux ≥ 0.
pub(super) fn check_flux(flux: f64) -> Result<(), Fault> {
    check_range(flux, flux >= 0.0, "the flux", "flux ≥ 0")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reflectance_may_be_zero_but_not_one() {
        assert!(Material::new(vec![0.0], vec![0.0]).is_ok());
        assert!(Material::new(vec![1.0_f64.next_down()], vec![0.0]).is_ok());
        for rho in [1.0, 1.2, -1e-300] {
            assert!(matches!(Material::new(vec![rho], vec![0.0]), Err(Fault::OutOfRange { .. })));
        }
    }

    #[test]
    fn numbers_are_finite_and_one_per_band() {
        assert!(matches!(Material::new(vec![f64::NAN], vec![0.0]), Err(Fault::NotFinite { .. })));
        assert!(matches!(Material::new(vec![0.5], vec![f64::INFINITY]), Err(Fault::NotFinite { .. })));
        assert!(matches!(Material::new(vec![0.5], vec![-1.0]), Err(Fault::OutOfRange { .. })));
        assert!(matches!(Material::new(vec![0.5; 3], vec![1.0]), Err(Fault::WrongCount { .. })));
    }
}
