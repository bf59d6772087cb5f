//! Push and pull of polynomials between nested levels of elements.
//!
//! ```text
//! y = Σ_levels Pᵀ G P x ,     P pulls the leaves' coefficients up to a level (`two_scale`)
//! ```
//!
//! Linked at the leaves only, this is the operator of all pairs. A link of larger elements stands for the
//! products of all their leaves with what the kernel has beyond its projection left out (Gortler, Schröder,
//! Cohen, Hanrahan 1993).

use std::ops::Range;

use radiosity::elements::Elements;

use crate::two_scale::TwoScale;

/// Coefficients of nested levels of elements, the last of them the leaves.
#[derive(Debug)]
pub(crate) struct Scales {
    nodes: Vec<Node>,
    /// The coefficients of the last level.
    leaves: Range<usize>,
}

#[derive(Debug)]
struct Node {
    /// Its coefficients among those of all levels.
    coefficients: Range<usize>,
    parent: Option<Parent>,
}

/// The element of the level before of which an element is a part.
#[derive(Debug)]
struct Parent {
    /// Its index among the nodes.
    node: usize,
    scale: TwoScale,
}

impl Scales {
    /// The nodes of `levels`, each a cut of the cells of the one before.
    pub(crate) fn new(levels: &[Elements]) -> Self {
        let mut nodes: Vec<Node> = Vec::new();
        let (mut before, mut end) = (None, 0);
        let mut leaves = 0..0;
        for elements in levels {
            let (first, start) = (nodes.len(), end);
            for element in elements.list() {
                let parent = before.and_then(|(coarse, start): (&Elements, usize)| {
                    let index = coarse.at(element.surface, element.rect.center())?;
                    let scale = TwoScale::new(&coarse.list()[index], element);
                    Some(Parent { node: start + index, scale })
                });
                nodes.push(Node { coefficients: end..end + element.basis.len(), parent });
                end += element.basis.len();
            }
            (before, leaves) = (Some((elements, first)), start..end);
        }
        Self { nodes, leaves }
    }

    /// The coefficients of all levels, from those of the leaves.
    pub(crate) fn pull(&self, leaves: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.leaves.end];
        all[self.leaves.clone()].copy_from_slice(leaves);
        for Node { coefficients, parent } in self.nodes.iter().rev() {
            let Some(Parent { node, scale }) = parent else { continue };
            let (above, own) = all.split_at_mut(coefficients.start);
            scale.pull(&own[..coefficients.len()], &mut above[self.nodes[*node].coefficients.clone()]);
        }
        all
    }

    /// The coefficients of the leaves, from those of all levels added; the transpose of [`Scales::pull`].
    pub(crate) fn push(&self, mut all: Vec<f64>) -> Vec<f64> {
        for Node { coefficients, parent } in &self.nodes {
            let Some(Parent { node, scale }) = parent else { continue };
            let (above, own) = all.split_at_mut(coefficients.start);
            scale.push(&above[self.nodes[*node].coefficients.clone()], &mut own[..coefficients.len()]);
        }
        all.split_off(self.leaves.start)
    }
}
