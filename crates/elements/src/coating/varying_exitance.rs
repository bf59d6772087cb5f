//! Emitted exitance that varies over an element.

use super::element_pattern::ElementPattern;
use crate::element::Element;

/// The emitted exitance E₀(x) of an element, with e_k = ∫ E₀ φ_k dA.
#[derive(Debug)]
pub(super) struct VaryingExitance {
    pub(super) element_pattern: ElementPattern,
    /// Factor of the light group, by which the pattern is multiplied.
    pub(super) factor: f64,
    /// e (W m⁻² times length).
    pub(super) coefficients: Vec<f64>,
}

impl VaryingExitance {
    /// Exitance of an element, `factor` times its pattern.
    pub(super) fn new(element: &Element, element_pattern: ElementPattern, factor: f64) -> Self {
        let coefficients = element_pattern.vector(element).iter().map(|e| factor * e).collect();
        Self { element_pattern, factor, coefficients }
    }

    /// E₀ (W m⁻²) at parameters of the surface.
    pub(super) fn at(&self, parameters: [f64; 2]) -> f64 {
        self.factor * self.element_pattern.at(parameters)
    }

    /// ∫ E₀ dA / A.
    pub(super) fn mean(&self, element: &Element) -> f64 {
        self.coefficients[0] / element.area.sqrt()
    }
}
