//! The hierarchy: the tree, its leaves and the links between its nodes.

use radiosity_elements::mesh::CellRefinement;
use radiosity_geom::Rect;
use serde::{Deserialize, Serialize};

use super::fields::Fields;
use super::links::{Link, Links};
use super::tree::Tree;

/// Numbers of nodes, links and pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// Surfaces.
    pub surfaces: usize,
    /// Nodes: clusters, surfaces and cells.
    pub nodes: usize,
    /// Leaves, the elements that carry constants.
    pub leaves: usize,
    /// Links, those of which no ray came through included.
    pub links: usize,
    /// Links of which at least one end is a cluster.
    pub cluster_links: usize,
    /// Links of which no ray came through.
    pub hidden: usize,
    /// Pairs left out since one lies behind the other, over all rounds.
    pub dropped: usize,
    /// Rounds of refinement.
    pub rounds: usize,
}

/// An element that carries a constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leaf {
    /// Index of its surface in the scene.
    pub surface: usize,
    /// The parameters that it covers, as far as the surface exists there.
    pub rect: Rect,
    /// Area (scene length²).
    pub area: f64,
}

/// The tree with its links.
#[derive(Debug)]
pub struct Hierarchy {
    tree: Tree,
    links: Links,
    /// The nodes that are leaves, surface by surface.
    nodes: Vec<usize>,
    leaves: Vec<Leaf>,
    /// The first leaf of each surface, and the number of leaves.
    starts: Vec<usize>,
    counts: Counts,
}

impl Hierarchy {
    /// The hierarchy of a tree with a list of links; `dropped` and `rounds` are told by the counts.
    pub(crate) fn new(tree: Tree, list: &[Link], dropped: usize, rounds: usize) -> Self {
        let (mut nodes, mut starts) = (Vec::new(), vec![0]);
        for surface in 0..tree.surfaces() {
            nodes.extend(tree.leaves_of(surface));
            starts.push(nodes.len());
        }
        let leaf = |node: &usize| {
            let node = &tree.nodes()[*node];
            let face = node.face.as_ref();
            face.map(|face| Leaf { surface: face.surface, rect: face.rect, area: node.area })
        };
        let leaves: Vec<Leaf> = nodes.iter().filter_map(leaf).collect();
        let has_cluster = |link: &&Link| link.pair.iter().any(|node| (*node as usize) < tree.clusters());
        let counts = Counts {
            surfaces: tree.surfaces(),
            nodes: tree.nodes().len(),
            leaves: leaves.len(),
            links: list.len(),
            cluster_links: list.iter().filter(has_cluster).count(),
            hidden: list.iter().filter(|link| link.weight == 0.0).count(),
            dropped,
            rounds,
        };
        let links = Links::new(tree.nodes().len(), list);
        Self { tree, links, nodes, leaves, starts, counts }
    }

    /// The tree, to be refined further.
    pub(crate) fn into_tree(self) -> Tree {
        self.tree
    }

    /// The numbers of its parts.
    pub(super) fn counts(&self) -> Counts {
        self.counts
    }

    /// The leaves, surface by surface.
    pub(super) fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    /// Indices of the leaves of a surface.
    pub fn of_surface(&self, surface: usize) -> std::ops::Range<usize> {
        self.starts[surface]..self.starts[surface + 1]
    }

    /// The leaf of a surface that holds the parameters (u, v) ∈ [−1, 1]²; None in a hole that fills a cell.
    pub fn leaf_at(&self, surface: usize, place: [f64; 2]) -> Option<usize> {
        let node = self.tree.leaf_at(surface, place)?;
        let own = self.of_surface(surface);
        self.nodes[own.clone()].iter().position(|leaf| *leaf == node).map(|place| own.start + place)
    }

    /// Cut of the cell `rect` of a surface.
    pub(crate) fn cut_of(&self, surface: usize, rect: &Rect) -> CellRefinement {
        self.tree.cut_of(surface, rect)
    }

    /// Fields that all nodes send, from the radiosity of the leaves (W m⁻²).
    pub fn pull(&self, radiosity: &[f64]) -> Fields {
        Fields::pull(&self.tree, &self.nodes, radiosity)
    }

    /// The power that the leaves receive (W), from what all nodes receive; the transpose of
    /// [`Hierarchy::pull`].
    pub fn push(&self, received: Fields) -> Vec<f64> {
        received.push(&self.tree, &self.nodes)
    }

    /// T B, the power that the leaves receive (W) from their radiosity (W m⁻²); T is symmetric.
    pub fn exchange(&self, radiosity: &[f64]) -> Vec<f64> {
        self.push(self.links.gather(&self.tree, &self.pull(radiosity)))
    }

    /// T_ii of each leaf: the light that it sends to itself over links of the faces that contain it (scene
    /// length²).
    pub(crate) fn own(&self) -> Vec<f64> {
        let nodes = self.tree.nodes();
        let clusters = self.tree.clusters();
        let mut density = vec![0.0; nodes.len()];
        for node in clusters..nodes.len() {
            if nodes[node].area > 0.0 {
                density[node] += self.links.own(node) / nodes[node].area.powi(2);
            }
            self.tree.children(node).for_each(|child| density[child] = density[node]);
        }
        self.nodes.iter().map(|leaf| density[*leaf] * nodes[*leaf].area.powi(2)).collect()
    }

    /// The sum over the leaves below each node, from a number on each leaf.
    pub(crate) fn sums(&self, values: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.tree.nodes().len()];
        self.nodes.iter().zip(values).for_each(|(leaf, value)| sums[*leaf] = *value);
        for node in (0..sums.len()).rev().filter(|node| !self.tree.nodes()[*node].children.is_empty()) {
            sums[node] = self.tree.children(node).map(|child| sums[child]).sum();
        }
        sums
    }
}
