//! Reflected light, gathered at a point from all surfaces with all shadows.
//!
//! ```text
//! S(x) = ∫ κ(x, y) V(x, y) (ρ(y) E(y) + τ E'(y)) dA_y        W m⁻²
//! ```
//!
//! with the irradiance E' of the other side of what lets light through.
//!
//! E(y) is any known irradiance at the points y, not projected on polynomials. The reflected radiosity ρ E is
//! tabulated once per element; each point x sums over the tables ([`crate`]).

use radiosity_elements::Element;
use radiosity_elements::coating::Coating;
use radiosity_elements::patch::Node;
use radiosity_visibility::Visibility;
use rayon::prelude::*;

use crate::cells::tree::{Steps, Tree};
use crate::coats::Coats;
use crate::occluders::{Occluders, Site};
use crate::point_lights::PointLights;
use crate::receiver_point::ReceiverPoint;
use crate::traversal::Traversal;

/// Accuracy ε down to which a cell may err by the irradiance times ε, since the errors of cells cancel. Finer
/// ones do not, and more cells have them: then each may err by ε²/10⁻³. Measured in a box with a luminous
/// ceiling: with ε for each the whole erred by 9e-4, 2.6e-4, 1.2e-4, 7e-5 for ε = 1e-3, 1e-4, 1e-5, 1e-6 at
/// points not nearer than a thirtieth of its side to an edge.
const CANCELLING: f64 = 1e-3;

/// Irradiance (W m⁻²) per band at a node of an element.
pub(crate) type IrradianceAt<'a> = &'a (dyn Fn(usize, &Node) -> Vec<f64> + Sync);

/// Mean over the scene (W m⁻²) of a radiosity with these coefficients in the orthonormal bases, element by
/// element; errors are judged by it. 1 where nothing shines.
pub fn scale(elements: &[Element], radiosity: impl Iterator<Item = f64>) -> f64 {
    let area: f64 = elements.iter().map(|element| element.area).sum();
    let constants = elements.iter().flat_map(|element| &element.constant);
    let power: f64 = constants.zip(radiosity).map(|(c, b)| c * b).sum();
    if power > 0.0 { power / area } else { 1.0 }
}

/// The radiosity that reflecting elements send, tabulated.
#[derive(Debug)]
pub struct Reflection<'a> {
    visibility: &'a Visibility,
    trees: Vec<Tree>,
    /// The element of each tree.
    elements: Vec<usize>,
    /// Mean radiosity per band (W m⁻²).
    scale: Vec<f64>,
    eps: f64,
}

impl<'a> Reflection<'a> {
    /// The light that `elements`, with one coating per band, reflect under the irradiance `lit`, to which
    /// `points` belong, to be gathered to about the relative accuracy `eps`. `scale` > 0 is the mean radiosity
    /// per band.
    pub fn new(
        elements: &[Element],
        coatings: &[&Coating],
        visibility: &'a Visibility,
        lit: IrradianceAt<'_>,
        points: &PointLights,
        scale: Vec<f64>,
        eps: f64,
    ) -> Self {
        let steps = |element: &Element| match points.is_empty() {
            true => Steps::Nowhere,
            false => match points.levels_of_beams(&element.bounds()) {
                0 => Steps::Shadows,
                levels => Steps::Beams(levels),
            },
        };
        let reflects = |i: &usize| coatings.iter().any(|coating| coating.scatters(*i));
        let reflecting: Vec<usize> = (0..elements.len()).filter(reflects).collect();
        let tree = |element: &usize| {
            let is_flat = elements[*element].plane.is_some();
            let field = |node: &Node, out: &mut [f64]| {
                for ((out, lit), coating) in out.iter_mut().zip(lit(*element, node)).zip(coatings) {
                    *out = coating.reflectance_about(*element, node, is_flat) * lit;
                }
                let behind = coatings.iter().find_map(|own| own.behind_node(*element, node, is_flat));
                let Some(behind) = behind else { return };
                let other_side = Node { normal: -node.normal, ..*node };
                for ((out, lit), coating) in out.iter_mut().zip(lit(behind, &other_side)).zip(coatings) {
                    *out += coating.transmittance(*element) * lit;
                }
            };
            Tree::new(&elements[*element], &scale, steps(&elements[*element]), eps, &field)
        };
        let trees = reflecting.par_iter().with_max_len(1).map(tree).collect();
        Self { visibility, trees, elements: reflecting, scale, eps }
    }

    /// Number of bands.
    pub(crate) fn bands(&self) -> usize {
        self.scale.len()
    }

    /// Possible occluders between a site and the reflecting elements.
    pub fn around(&self, site: &Site) -> Occluders {
        Occluders::new(self.visibility, self.trees.iter().map(Tree::sender), site)
    }

    /// Irradiance (W m⁻²) per band at a point of a site; `other` light arrives too: the tolerance is relative
    /// to both.
    pub fn irradiance(&self, receiver: &ReceiverPoint, occluders: &Occluders, other: &[f64]) -> Vec<f64> {
        self.irradiance_within(self.eps, receiver, occluders, other)
    }

    /// Irradiance (W m⁻²) per band as of [`Self::irradiance`], to another relative accuracy `eps`.
    pub fn irradiance_within(
        &self,
        eps: f64,
        receiver: &ReceiverPoint,
        occluders: &Occluders,
        other: &[f64],
    ) -> Vec<f64> {
        self.sum(&self.parts(eps, receiver, occluders, other))
    }

    /// Irradiance (W m⁻²) as of [`Self::irradiance_within`], apart by the coats of the reflecting elements: all
    /// bands of one coat after those of another.
    pub(crate) fn irradiance_by_coat(
        &self,
        eps: f64,
        receiver: &ReceiverPoint,
        occluders: &Occluders,
        other: &[f64],
        coats: &Coats,
    ) -> Vec<f64> {
        let bands = self.scale.len();
        let mut sums = vec![0.0; coats.count() * bands];
        let parts = self.parts(eps, receiver, occluders, other);
        for (part, element) in parts.chunks_exact(bands).zip(&self.elements) {
            let own = &mut sums[bands * coats.of_element(*element)..][..bands];
            own.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
        sums
    }

    /// The irradiance from each reflecting element to the relative accuracy `eps`, band after band.
    fn parts(&self, eps: f64, receiver: &ReceiverPoint, occluders: &Occluders, other: &[f64]) -> Vec<f64> {
        let mut traversal = Traversal::new(receiver, self.visibility, occluders);
        let add = |traversal: &mut Traversal, index: usize, tolerance: f64, out: &mut [f64]| {
            traversal.add(index, &self.trees[index], tolerance, out);
        };
        let share = eps * (eps / CANCELLING).min(1.0);
        let other = self.relative(other);
        let level = |parts: &[f64]| self.relative(&self.sum(parts));
        traversal.within_share(&self.trees, share, other, add, level)
    }

    /// Sum over the elements, per band.
    fn sum(&self, parts: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.scale.len()];
        for part in parts.chunks_exact(sum.len()) {
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
        sum
    }

    /// Mean over the bands of E over the band's scale.
    fn relative(&self, irradiance: &[f64]) -> f64 {
        let sum: f64 = irradiance.iter().zip(&self.scale).map(|(e, scale)| e / scale).sum();
        sum / self.scale.len() as f64
    }
}
