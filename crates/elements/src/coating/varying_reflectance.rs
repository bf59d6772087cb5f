//! Reflectance that varies over an element.

use std::sync::OnceLock;

use radiosity_geom::Surface;

use super::element_pattern::ElementPattern;
use super::square_root::square_root;
use crate::element::Element;

/// The reflectance ρ(x) of an element, with S_kl = ∫ ρ φ_k φ_l dA, by which coefficients of irradiance become
/// those of reflected radiosity.
#[derive(Debug)]
pub(super) struct VaryingReflectance {
    pub(super) element_pattern: ElementPattern,
    /// S, row-major.
    pub(super) matrix: Vec<f64>,
    square_root: OnceLock<Vec<f64>>,
    /// ∫ ρ dA / A.
    pub(super) mean: f64,
}

impl VaryingReflectance {
    /// Reflectance of an element by its pattern.
    pub(super) fn new(element: &Element, element_pattern: ElementPattern) -> Self {
        let matrix = element_pattern.matrix(element);
        // φ_0 is constant.
        let mean = matrix[0];
        Self { element_pattern, matrix, square_root: OnceLock::new(), mean }
    }

    /// S^½, row-major.
    pub(super) fn square_root(&self) -> &[f64] {
        self.square_root.get_or_init(|| square_root(&self.matrix))
    }

    /// ρ at parameters of the surface.
    pub(super) fn at(&self, parameters: [f64; 2]) -> f64 {
        self.element_pattern.at(parameters)
    }

    /// The largest ρ of the pattern.
    pub(super) fn most(&self) -> f64 {
        self.element_pattern.most()
    }

    /// About ρ at parameters of the surface: its mean over a tile, which few points of a cell represent
    /// better.
    pub(super) fn about(&self, parameters: [f64; 2]) -> f64 {
        self.element_pattern.tiles.at(parameters).unwrap_or_else(|| self.at(parameters))
    }

    /// The shape of its surface.
    pub(super) fn shape(&self) -> &dyn Surface {
        self.element_pattern.shape.as_ref()
    }

    /// Whether it is the same pattern.
    pub(super) fn is_as(&self, other: &Self) -> bool {
        self.element_pattern.is_as(&other.element_pattern)
    }
}
