//! Cut of a scene into elements, and the polynomials that they carry.

use serde::{Deserialize, Serialize};

use super::cells::Layers;
use super::space::Space;

/// Cut of a scene into elements, and the polynomials that they carry.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Discretization {
    /// Order of every element that does not state its own, ≤ [`HIGHEST_ORDER`](super::basis::HIGHEST_ORDER).
    pub order: usize,
    /// Which polynomials of that order.
    pub space: Space,
    /// Cuts of surfaces that do not state their own.
    pub subdivide: Subdivide,
    /// Further cuts of the outermost cells of every surface.
    pub layers: Layers,
}

impl Discretization {
    /// Total degree `order` on `cuts` × `cuts` cells of every surface, no layers.
    pub fn uniform(order: usize, cuts: usize) -> Self {
        let subdivide = Subdivide::Uniform(cuts);
        Self { order, space: Space::Total, subdivide, layers: Layers::NONE }
    }

    /// Whether surfaces are cut for the sake of faces that are near.
    pub(super) fn follows_near_faces(&self) -> bool {
        matches!(self.subdivide, Subdivide::Auto { near_layers: true, .. }) && self.layers.count == 0
    }
}

/// Cuts along u and v of a surface that does not state its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Subdivide {
    /// 2 × 2 where `occluded` and the surface is longer than half the scene, 1 otherwise; cut along what divides its
    /// light too, in place of the middle where that is near.
    Auto {
        /// Whether anything in the scene can cast a shadow.
        occluded: bool,
        /// Whether surfaces are cut along the outlines of others near by (`near_outlines`), and those that others face
        /// from near by have layers at their sides (`nearness`), where no layers are asked for.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        near_layers: bool,
    },
    /// This number along u and along v of every surface.
    Uniform(usize),
    /// By the area of the surface (`resolution`), as fine as so many rays from all of them support, and along what
    /// divides its light; limits the order as well.
    Graded {
        /// Rays from all surfaces together, spread by area.
        rays: u64,
    },
}

impl Subdivide {
    /// Whether surfaces are cut where things before them make steps of light too.
    pub(super) fn follows_light(self) -> bool {
        match self {
            Self::Auto { occluded, .. } => occluded,
            Self::Graded { .. } => true,
            Self::Uniform(_) => false,
        }
    }
}
