//! Fields over the whole tree, and push-pull between them and the leaves.
//!
//! ```text
//! pull:  B_p = Σ_c (A_c/A_p) B_c ,     x_p = Σ_faces m_c B_c + Σ_clusters x_c ,     m = ∫ A_l Y_lm(n) dA
//! push:  Φ_c = Φ_c + (A_c/A_p) Φ_p ,   Φ_c = Φ_c + m_c·f_p ,   f_c = f_c + f_p
//! ```
//!
//! Push is the transpose of pull. Pull keeps constants, push keeps power; Φ/A, the irradiance, is handed down
//! unchanged.

use radiosity_core::dot;

use super::harmonics::{HARMONICS, add};
use super::tree::Tree;

/// A number on every face and nine on every cluster: radiosity (W m⁻²) and directional intensity (W, times π
/// per sr) going up, power (W) and directional field (W m⁻²) coming down.
#[derive(Clone, Debug, PartialEq)]
pub struct Fields {
    /// Of the faces, in the order of the tree.
    pub faces: Vec<f64>,
    /// Of the clusters, in the order of the tree.
    pub clusters: Vec<[f64; HARMONICS]>,
}

impl Fields {
    /// Fields that are zero everywhere.
    pub(crate) fn zero(tree: &Tree) -> Self {
        let faces = vec![0.0; tree.nodes().len() - tree.clusters()];
        Self { faces, clusters: vec![[0.0; HARMONICS]; tree.clusters()] }
    }

    /// The sum of all products.
    pub fn dot(&self, other: &Self) -> f64 {
        let [own, others] = [self, other].map(|fields| fields.clusters.as_flattened());
        dot(&self.faces, &other.faces) + dot(own, others)
    }

    /// Fields that all nodes send, from the radiosity (W m⁻²) of the `leaves`, nodes of `tree`.
    pub(crate) fn pull(tree: &Tree, leaves: &[usize], radiosity: &[f64]) -> Self {
        let clusters = tree.clusters();
        let mut fields = Self::zero(tree);
        leaves.iter().zip(radiosity).for_each(|(leaf, radiosity)| fields.faces[leaf - clusters] = *radiosity);
        for node in (clusters..tree.nodes().len()).rev().filter(|node| !is_leaf(tree, *node)) {
            let part = |child: usize| share(tree, node, child) * fields.faces[child - clusters];
            fields.faces[node - clusters] = tree.children(node).map(part).sum();
        }
        for node in (0..clusters).rev() {
            let mut sum = [0.0; HARMONICS];
            for child in tree.children(node) {
                match &tree.nodes()[child].face {
                    Some(face) => add(&mut sum, fields.faces[child - clusters], &face.moments),
                    None if child < clusters => add(&mut sum, 1.0, &fields.clusters[child]),
                    None => {}
                }
            }
            fields.clusters[node] = sum;
        }
        fields
    }

    /// The power (W) of the `leaves`, from what all nodes receive.
    pub(crate) fn push(mut self, tree: &Tree, leaves: &[usize]) -> Vec<f64> {
        let clusters = tree.clusters();
        for node in 0..clusters {
            let field = self.clusters[node];
            for child in tree.children(node) {
                match &tree.nodes()[child].face {
                    Some(face) => self.faces[child - clusters] += dot(&field, &face.moments),
                    None if child < clusters => add(&mut self.clusters[child], 1.0, &field),
                    None => {}
                }
            }
        }
        for node in clusters..tree.nodes().len() {
            let power = self.faces[node - clusters];
            for child in tree.children(node) {
                self.faces[child - clusters] += share(tree, node, child) * power;
            }
        }
        leaves.iter().map(|leaf| self.faces[leaf - clusters]).collect()
    }
}

fn is_leaf(tree: &Tree, node: usize) -> bool {
    tree.nodes()[node].children.is_empty()
}

/// The part of the area of a face that a cell of it has.
fn share(tree: &Tree, face: usize, cell: usize) -> f64 {
    tree.nodes()[cell].area / tree.nodes()[face].area
}
