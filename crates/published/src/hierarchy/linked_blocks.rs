//! Blocks of polynomials that are linked at any level.
//!
//! ```text
//! y = Σ_links P_pᵀ G_pq P_q x + its transpose ,     P pulls the leaves' coefficients up to a node (`two_scale`)
//! ```
//!
//! Linked at the leaves only, this is the flat operator of [`Blocks`](radiosity_kernel::Blocks). A link of
//! larger elements stands for the products of all their leaves with what the kernel has beyond its projection
//! left out (Gortler, Schröder, Cohen, Hanrahan 1993).

use std::ops::Range;

use radiosity_core::dot;
use radiosity_elements::Elements;
use radiosity_work::interruption::check_interrupt;

use super::two_scale::TwoScale;

/// An element of one level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelElement {
    /// Its level, 0 for the largest elements.
    pub level: usize,
    /// Its index there.
    pub index: usize,
}

/// Levels of nested elements, the last of them the leaves, with blocks between elements of any level.
#[derive(Debug, Default)]
pub struct LinkedBlocks {
    nodes: Vec<Node>,
    /// The first node of each level, and the number of nodes.
    starts: Vec<usize>,
    links: Vec<Link>,
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

/// G of two nodes, row by row.
#[derive(Debug)]
struct Link {
    pair: [usize; 2],
    values: Vec<f64>,
}

impl LinkedBlocks {
    /// The nodes of `levels`, each a cut of the cells of the one before, without links.
    pub fn new(levels: &[&Elements]) -> Self {
        let mut all = Self::default();
        for (level, elements) in levels.iter().enumerate() {
            all.starts.push(all.nodes.len());
            for element in elements.list() {
                check_interrupt();
                let coarse = level.checked_sub(1).map(|above| (levels[above], all.starts[above]));
                let parent = coarse.and_then(|(coarse, start)| {
                    let index = coarse.at(element.surface, element.rect.center())?;
                    let scale = TwoScale::new(&coarse.list()[index], element);
                    Some(Parent { node: start + index, scale })
                });
                let first = all.nodes.last().map_or(0, |node| node.coefficients.end);
                all.nodes.push(Node { coefficients: first..first + element.basis.len(), parent });
            }
        }
        all.starts.push(all.nodes.len());
        all
    }

    /// Links two elements by G, row by row: rows of the first, columns of the second. It is used both ways; a
    /// link of an element with itself once.
    ///
    /// # Panics
    /// If there is no such element, or `values` has another size than the block.
    pub fn link(&mut self, elements: [LevelElement; 2], values: &[f64]) {
        let pair = elements.map(|element| self.starts[element.level] + element.index);
        let [rows, columns] = pair.map(|node| self.nodes[node].coefficients.len());
        assert_eq!(values.len(), rows * columns, "the block has a number for each pair of functions");
        self.links.push(Link { pair, values: values.to_vec() });
    }

    /// The coefficients of all levels, from those of the leaves.
    pub fn pull(&self, leaves: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.dim()];
        all[self.leaves()].copy_from_slice(leaves);
        for Node { coefficients, parent } in self.nodes.iter().rev() {
            let Some(Parent { node, scale }) = parent else { continue };
            let (above, own) = all.split_at_mut(coefficients.start);
            scale.pull(&own[..coefficients.len()], &mut above[self.nodes[*node].coefficients.clone()]);
        }
        all
    }

    /// The coefficients of the leaves, from those of all levels added; the transpose of
    /// [`LinkedBlocks::pull`].
    pub fn push(&self, mut all: Vec<f64>) -> Vec<f64> {
        for Node { coefficients, parent } in &self.nodes {
            let Some(Parent { node, scale }) = parent else { continue };
            let (above, own) = all.split_at_mut(coefficients.start);
            scale.push(&above[self.nodes[*node].coefficients.clone()], &mut own[..coefficients.len()]);
        }
        all.split_off(self.leaves().start)
    }

    /// y = G x on the leaves, element by element.
    pub fn apply(&self, x: &[f64]) -> Vec<f64> {
        let sent = self.pull(x);
        let mut received = vec![0.0; self.dim()];
        self.links.iter().for_each(|link| self.add(link, &sent, &mut received));
        self.push(received)
    }

    fn add(&self, Link { pair, values }: &Link, x: &[f64], y: &mut [f64]) {
        let [rows, columns] = pair.map(|node| self.nodes[node].coefficients.clone());
        for (row, line) in rows.zip(values.chunks_exact(columns.len())) {
            y[row] += dot(line, &x[columns.clone()]);
            if pair[0] != pair[1] {
                y[columns.clone()].iter_mut().zip(line).for_each(|(y, g)| *y += g * x[row]);
            }
        }
    }

    /// Number of coefficients of all levels.
    fn dim(&self) -> usize {
        self.nodes.last().map_or(0, |node| node.coefficients.end)
    }

    /// The coefficients of the last level.
    fn leaves(&self) -> Range<usize> {
        let first = self.starts.iter().rev().nth(1).and_then(|start| self.nodes.get(*start));
        first.map_or(0, |node| node.coefficients.start)..self.dim()
    }
}
