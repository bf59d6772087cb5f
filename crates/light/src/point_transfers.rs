//! Transfers to a point: the irradiance there from each function of each element.
//!
//! ```text
//! T_jl(x) = ∫_j κ(x, y) V(x, y) φ_jl(y) dA_y
//! ```
//!
//! φ_jl are the orthonormal polynomials of element j. Each element is a tree of cells ([`crate`]) with one
//! channel for each of its functions, so that shadows are found once for all of them. Collocation is made of
//! these.

use radiosity_elements::Element;
use radiosity_elements::patch::Node;
use radiosity_visibility::Visibility;
use rayon::prelude::*;

use crate::cells::tree::{Steps, Tree};
use crate::occluders::{Occluders, Site};
use crate::receiver_point::ReceiverPoint;
use crate::traversal::Traversal;

/// The functions of all elements, tabulated.
#[derive(Debug)]
pub struct PointTransfers<'a> {
    elements: &'a [Element],
    visibility: &'a Visibility,
    trees: Vec<Tree>,
    /// Channels of each tree: as many as the largest basis has functions.
    channels: usize,
    eps: f64,
}

impl<'a> PointTransfers<'a> {
    /// Transfers from `elements`, each with an error of about `eps` times those of the constant 1 from all.
    pub fn new(elements: &'a [Element], visibility: &'a Visibility, eps: f64) -> Self {
        let channels = elements.iter().map(|element| element.basis.len()).max().unwrap_or(1);
        let scale = vec![1.0; channels];
        let tree = |element: &Element| {
            let root = element.area.sqrt();
            let field = |node: &Node, out: &mut [f64]| {
                out.fill(0.0);
                out.iter_mut().zip(element.basis.values(node)).for_each(|(out, value)| *out = root * value);
            };
            Tree::new(element, &scale, Steps::Nowhere, eps, &field)
        };
        let trees = elements.par_iter().map(tree).collect();
        Self { elements, visibility, trees, channels, eps }
    }

    /// Possible occluders between a site and the elements.
    pub fn around(&self, site: &Site) -> Occluders {
        Occluders::new(self.visibility, self.trees.iter().map(Tree::sender), site)
    }

    /// T_jl (1/length) at a point of the site that `occluders` were listed for, function after function of one
    /// element after another.
    pub fn at(&self, receiver: &ReceiverPoint, occluders: &Occluders) -> Vec<f64> {
        let mut traversal = Traversal::new(receiver, self.visibility, occluders);
        let add = |traversal: &mut Traversal, index: usize, tolerance: f64, out: &mut [f64]| {
            traversal.add(index, &self.trees[index], tolerance, out);
        };
        let constants = |parts: &[f64]| parts.iter().step_by(self.channels).sum();
        let parts = traversal.within_share(&self.trees, self.eps, 0.0, add, constants);
        let own = |(element, part): (&Element, &[f64])| {
            let root = element.area.sqrt();
            part[..element.basis.len()].iter().map(|value| value / root).collect::<Vec<_>>()
        };
        self.elements.iter().zip(parts.chunks_exact(self.channels)).flat_map(own).collect()
    }
}
