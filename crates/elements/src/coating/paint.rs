//! Paint: reflectance that varies over an element.

use std::sync::{Arc, OnceLock};

use radiosity_geom::Surface;
use radiosity_scene::Pattern;

use super::root::square_root;
use super::varied::Varied;
use crate::element::Element;

/// The reflectance ρ(x) of an element, with S_kl = ∫ ρ φ_k φ_l dA, by which coefficients of irradiance become
/// those of reflected radiosity.
#[derive(Debug)]
pub(super) struct Paint {
    pub(super) varied: Varied,
    /// S, row-major.
    pub(super) matrix: Vec<f64>,
    root: OnceLock<Vec<f64>>,
    /// ∫ ρ dA / A.
    pub(super) mean: f64,
}

impl Paint {
    /// Reflectance of a band of `pattern` on an element of a surface of this shape.
    pub(super) fn new(
        element: &Element,
        shape: &Arc<dyn Surface>,
        pattern: &Arc<Pattern>,
        band: usize,
    ) -> Self {
        let varied = Varied::new(element, shape, pattern, band);
        let matrix = varied.matrix(element);
        // φ_0 is constant.
        let mean = matrix[0];
        Self { varied, matrix, root: OnceLock::new(), mean }
    }

    /// S^½, row-major.
    pub(super) fn root(&self) -> &[f64] {
        self.root.get_or_init(|| square_root(&self.matrix))
    }

    /// ρ at parameters of the surface.
    pub(super) fn at(&self, parameters: [f64; 2]) -> f64 {
        self.varied.at(parameters)
    }

    /// The largest ρ of the pattern.
    pub(super) fn most(&self) -> f64 {
        self.varied.most()
    }

    /// About ρ at parameters of the surface: its mean over a tile, which few points of a cell represent
    /// better.
    pub(super) fn about(&self, parameters: [f64; 2]) -> f64 {
        self.varied.tiles.at(parameters).unwrap_or_else(|| self.at(parameters))
    }

    /// The shape of its surface.
    pub(super) fn shape(&self) -> &dyn Surface {
        self.varied.shape.as_ref()
    }

    /// Whether it is the same pattern.
    pub(super) fn is_as(&self, other: &Self) -> bool {
        self.varied.is_as(&other.varied)
    }
}
