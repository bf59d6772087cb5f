//! Paint: reflectance that varies over an element.

use std::sync::Arc;

use radiosity_geom::Surface;

use super::root::square_root;
use super::tiles::Means;
use super::varied::Varied;
use crate::elements::element::Element;
use crate::scene::Pattern;

/// The reflectance ρ(x) of an element, with S_kl = ∫ ρ φ_k φ_l dA, by which coefficients of irradiance become those of
/// reflected radiosity.
#[derive(Debug)]
pub(super) struct Paint {
    varied: Varied,
    /// Means over tiles, where ρ has texels.
    means: Option<Means>,
    /// S, row-major.
    pub(super) matrix: Vec<f64>,
    /// S^½, row-major.
    pub(super) root: Vec<f64>,
    /// ∫ ρ dA / A.
    pub(super) mean: f64,
}

impl Paint {
    /// That of a band of `pattern` on an element of a surface of this shape.
    pub(super) fn new(
        element: &Element,
        shape: &Arc<dyn Surface>,
        pattern: &Arc<Pattern>,
        band: usize,
    ) -> Self {
        let varied = Varied { pattern: Arc::clone(pattern), band, shape: Arc::clone(shape) };
        let matrix = varied.matrix(element);
        // φ_0 is constant.
        let mean = matrix[0];
        let means = pattern.degree().is_none().then(|| Means::of(pattern, band, &element.rect));
        Self { root: square_root(&matrix), matrix, mean, means, varied }
    }

    /// ρ at parameters of the surface.
    pub(super) fn at(&self, parameters: [f64; 2]) -> f64 {
        self.varied.at(parameters)
    }

    /// About ρ at parameters of the surface: its mean over a tile, which few points of a cell represent better.
    pub(super) fn about(&self, parameters: [f64; 2]) -> f64 {
        self.means.as_ref().map_or_else(|| self.at(parameters), |means| means.at(parameters))
    }

    /// The shape of its surface.
    pub(super) fn shape(&self) -> &dyn Surface {
        self.varied.shape.as_ref()
    }

    /// Whether it is the same pattern.
    pub(super) fn is_as(&self, other: &Self) -> bool {
        self.varied.band == other.varied.band && self.varied.pattern == other.varied.pattern
    }
}
