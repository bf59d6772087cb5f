//! The leaves of a hierarchy as elements with constants, and its links as the transfer matrix between these.
//!
//! ```text
//! B_leaf = Σ_i √A_i x_i / Σ_i A_i ,     y_i = √A_i Φ_leaf / Σ_i A_i ,     i the elements on a leaf
//! ```
//!
//! x and y are coefficients of the area-orthonormal constants. A leaf has one element, what other surfaces
//! cover left out, or none where all of it is a hole or covered.

use radiosity_elements::cells::Layers;
use radiosity_elements::mesh::{Mesh, Tree};
use radiosity_elements::space::Space;
use radiosity_elements::{Discretization, Element, ElementError, Elements, Subdivide};
use radiosity_geom::Rect;
use radiosity_scene::Scene;
use radiosity_transport::Carrier;

use super::network::Hierarchy;

/// Constants on whole surfaces, of which the leaves are parts.
const WHOLE: Discretization =
    Discretization { order: 0, space: Space::Total, subdivide: Subdivide::Uniform(1), layers: Layers::NONE };

/// The elements on the leaves of a hierarchy of `scene`.
///
/// # Errors
/// As for [`Elements::new`].
pub fn leaf_elements(scene: &Scene, hierarchy: &Hierarchy) -> Result<Elements, ElementError> {
    let cells = |surface| Tree::cut_while(&Rect::FULL, 0, &|rect| hierarchy.cut_of(surface, rect));
    Elements::of_mesh(scene, &WHOLE, Mesh::new((0..scene.surfaces.len()).map(cells).collect()))
}

/// The links of a hierarchy between the elements on its leaves.
#[derive(Debug)]
pub struct LinkedElements<'a> {
    hierarchy: &'a Hierarchy,
    starts: Vec<usize>,
    /// The leaf of each element; None for covered parts, which rays find dark.
    leaves: Vec<Option<usize>>,
    /// √A_i of each element over Σ_i A_i of its leaf.
    weights: Vec<f64>,
}

impl<'a> LinkedElements<'a> {
    /// The links between `elements`, which are those of [`leaf_elements`].
    pub fn new(hierarchy: &'a Hierarchy, elements: &Elements) -> Self {
        let leaf = |element: &Element| match element.contact {
            Some(_) => None,
            None => hierarchy.leaf_at(element.surface, element.rect.center()),
        };
        let leaves: Vec<Option<usize>> = elements.list().iter().map(leaf).collect();
        let mut areas = vec![0.0; hierarchy.leaves().len()];
        let held = || elements.list().iter().zip(&leaves);
        held().for_each(|(element, leaf)| leaf.iter().for_each(|leaf| areas[*leaf] += element.area));
        let weight = |(element, leaf): (&Element, &Option<usize>)| {
            leaf.map_or(0.0, |leaf| element.constant[0] / areas[leaf])
        };
        let weights = held().map(weight).collect();
        Self { hierarchy, starts: elements.starts(), leaves, weights }
    }

    /// Coefficients of the irradiance of all elements, from the power (W) of the leaves.
    pub fn irradiance(&self, power: &[f64]) -> Vec<f64> {
        let own = self.leaves.iter().zip(&self.weights);
        own.map(|(leaf, weight)| leaf.map_or(0.0, |leaf| weight * power[leaf])).collect()
    }

    /// Radiosity of the leaves (W m⁻²), from the coefficients of the elements.
    fn radiosity(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut radiosity = vec![0.0; self.hierarchy.leaves().len()];
        for ((leaf, weight), x) in self.leaves.iter().zip(&self.weights).zip(coefficients) {
            leaf.iter().for_each(|leaf| radiosity[*leaf] += weight * x);
        }
        radiosity
    }
}

impl Carrier for LinkedElements<'_> {
    fn starts(&self) -> &[usize] {
        &self.starts
    }

    fn apply(&self, x: &[f64]) -> Vec<f64> {
        self.irradiance(&self.hierarchy.exchange(&self.radiosity(x)))
    }

    fn apply_transposed(&self, x: &[f64]) -> Vec<f64> {
        self.apply(x)
    }

    fn integrated_constant(&self, ones: &[f64]) -> Vec<f64> {
        self.apply(ones)
    }

    fn is_noisy(&self) -> bool {
        true
    }

    fn is_complete(&self, element: usize) -> bool {
        self.leaves[element].is_some()
    }
}
