//! Coatings: reflectance and emitted exitance of the elements, per band.
//!
//! ```text
//! B(x) = E₀ + ρ E(x) ,     0 ≤ ρ < 1
//! ```

use crate::elements::Element;
use crate::scene::Scene;

/// Reflectance and exitance of all elements in one band.
#[derive(Clone, Debug)]
pub struct Coating {
    /// ρ per element, in [0, 1).
    pub reflectance: Vec<f64>,
    /// Emitted exitance per element (W m⁻²), constant over it.
    pub exitance: Vec<f64>,
}

impl Coating {
    /// The coating of a scene's elements in band `band`.
    pub fn of(scene: &Scene, elements: &[Element], band: usize) -> Self {
        let surface = |element: &Element| &scene.surfaces[element.surface];
        Self {
            reflectance: elements.iter().map(|own| surface(own).material.reflectance[band]).collect(),
            exitance: elements.iter().map(|own| surface(own).exitance(band)).collect(),
        }
    }

    /// The same where nothing emits but the members of a light group, or of no group for None; their group is not
    /// dimmed.
    pub fn of_group(scene: &Scene, elements: &[Element], band: usize, group: Option<&str>) -> Self {
        let exitance = |element: &Element| {
            let surface = &scene.surfaces[element.surface];
            if surface.is_in(group) { surface.material.emission[band] } else { 0.0 }
        };
        Self { exitance: elements.iter().map(exitance).collect(), ..Self::of(scene, elements, band) }
    }

    /// The same where nothing is reflected.
    pub fn black(&self) -> Self {
        Self { reflectance: vec![0.0; self.reflectance.len()], exitance: self.exitance.clone() }
    }

    /// B = E₀ + ρ E of an element under the irradiance E (W m⁻²).
    pub fn radiosity(&self, element: usize, irradiance: f64) -> f64 {
        self.exitance[element] + self.reflectance[element] * irradiance
    }
}
