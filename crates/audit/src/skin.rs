//! Surfaces as light meets them: what a point of the front sends out by itself, and what it does with what
//! arrives.
//!
//! ```text
//! π L(ω) = M a(ω) + ρ E + τ E′        W m⁻²
//! ```
//!
//! with the exitance M, the relative radiance a (1 where it is diffuse), the reflectance ρ, the transmittance τ
//! and the irradiances E and E′ of this and of the other side.

use std::sync::Arc;

use radiosity_geom::DVec3;
use radiosity_scene::{Pattern, Radiance, Scene, SceneSurface};

use crate::spectrum::Spectrum;

/// Some bands of one side of a surface.
#[derive(Clone, Debug)]
pub(crate) struct Skin {
    /// Index of the first band, and how many there are in all.
    bands: [usize; 2],
    exitance: Spectrum,
    exitance_pattern: Option<Arc<Pattern>>,
    /// Factor of the light group.
    factor: f64,
    radiance: Option<Radiance>,
    reflectance: Spectrum,
    reflectance_pattern: Option<Arc<Pattern>>,
    pub(crate) transmittance: Spectrum,
    /// Fate of light that the side absorbs.
    pub(crate) absorbed: Absorbed,
}

/// Fate of light that a side absorbs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Absorbed {
    /// It is gone.
    Kept,
    /// It leaves the sheet of that number, whose temperature is even.
    Sheet { sheet: usize, emissivity: f64 },
}

impl Skin {
    /// The bands of `surface` from `first` on.
    pub(crate) fn of_light(surface: &SceneSurface, first: usize) -> Self {
        let material = &surface.material;
        let bands = material.reflectance.len();
        Self {
            bands: [first, bands],
            exitance: Spectrum::from_fn(first, bands, |band| surface.exitance(band)),
            exitance_pattern: material.emission_pattern.clone(),
            factor: surface.factor(),
            radiance: surface.radiance.clone(),
            reflectance: Spectrum::of(first, &material.reflectance),
            reflectance_pattern: material.reflectance_pattern.clone(),
            transmittance: Spectrum::of(first, &material.transmittance),
            absorbed: Absorbed::Kept,
        }
    }

    /// A side that sends out two kinds of light and is grey to them.
    pub(crate) fn grey(exitance: [f64; 2], reflectance: f64, absorbed: Absorbed) -> Self {
        Self {
            bands: [0, 2],
            exitance: Spectrum::of(0, &exitance),
            exitance_pattern: None,
            factor: 1.0,
            radiance: None,
            reflectance: Spectrum::of(0, &[reflectance; 2]),
            reflectance_pattern: None,
            transmittance: Spectrum::default(),
            absorbed,
        }
    }

    /// The skins of all surfaces, the bands from `first` on.
    pub(crate) fn all(scene: &Scene, first: usize) -> Vec<Self> {
        scene.surfaces.iter().map(|surface| Self::of_light(surface, first)).collect()
    }

    /// Whether it sends out anything by itself.
    pub(crate) fn emits(&self) -> bool {
        !self.exitance.is_dark()
    }

    /// Mean exitance (W m⁻²).
    pub(crate) fn mean_exitance(&self) -> Spectrum {
        self.exitance
    }

    /// Whether its exitance varies over the surface.
    pub(crate) fn is_patterned(&self) -> bool {
        self.exitance_pattern.is_some()
    }

    /// π times the radiance that it sends out by itself in a unit direction (W m⁻²).
    #[inline]
    pub(crate) fn sent(&self, parameters: [f64; 2], into: DVec3) -> Spectrum {
        let exitance = match &self.exitance_pattern {
            None => self.exitance,
            Some(pattern) => self.patterned(pattern, self.factor, parameters),
        };
        match &self.radiance {
            None => exitance,
            Some(radiance) => radiance.relative(into) * exitance,
        }
    }

    /// Its reflectance.
    #[inline]
    pub(crate) fn reflectance(&self, parameters: [f64; 2]) -> Spectrum {
        match &self.reflectance_pattern {
            None => self.reflectance,
            Some(pattern) => self.patterned(pattern, 1.0, parameters),
        }
    }

    fn patterned(&self, pattern: &Pattern, factor: f64, parameters: [f64; 2]) -> Spectrum {
        let [first, bands] = self.bands;
        Spectrum::from_fn(first, bands, |band| factor * pattern.at(band, parameters))
    }
}
