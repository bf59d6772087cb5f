//! The tree of nodes: clusters, below them whole surfaces, below these the cells of their parameters.
//!
//! The children of a node stand behind it in the list: up the tree is from the end to the beginning. Areas of
//! cells are scaled to add up to that of the face that was cut, so that means by area keep constants.

use std::sync::Arc;

use radiosity_elements::mesh::{Axis, CellRefinement};
use radiosity_geom::{Aabb, DVec3, Rect, Surface};
use smallvec::{SmallVec, smallvec};

use super::face::Face;
use super::grouping::{Group, group};

/// A cluster or a face.
#[derive(Debug)]
pub(crate) struct Node {
    /// Indices of its children, ascending.
    pub children: SmallVec<[u32; 4]>,
    /// Area of all its surfaces (scene length²).
    pub area: f64,
    /// Centre of a ball around it.
    pub center: DVec3,
    /// Radius of that ball (scene length).
    pub radius: f64,
    /// The face; None for a cluster.
    pub face: Option<Box<Face>>,
    /// Whether the face cannot be cut into cells.
    is_whole: bool,
}

/// All nodes: clusters from 0, then the surfaces in their order, then cells.
#[derive(Debug)]
pub(crate) struct Tree {
    nodes: Vec<Node>,
    clusters: usize,
    shapes: Vec<Arc<dyn Surface>>,
}

impl Tree {
    /// The tree over surfaces with these shapes; a shape without area gives a surface that exchanges nothing.
    pub(crate) fn new(shapes: Vec<Arc<dyn Surface>>) -> Self {
        let boxes: Vec<Aabb> = shapes.iter().map(|shape| shape.bounds(&Rect::FULL)).collect();
        let mut members: Vec<usize> = (0..shapes.len()).collect();
        let clusters = shapes.len().saturating_sub(1);
        let mut tree = Self { nodes: Vec::new(), clusters, shapes };
        if let Some(Group::Two(parts)) = group(&mut members, &boxes) {
            tree.add_cluster(&parts);
        }
        let whole = |(surface, shape): (usize, &Arc<dyn Surface>)| match Face::whole(surface, shape) {
            Some(face) => face_node(face, shape.area()),
            None => Node::nothing(boxes[surface].center()),
        };
        let faces: Vec<Node> = tree.shapes.iter().enumerate().map(whole).collect();
        tree.nodes.extend(faces);
        for cluster in (0..clusters).rev() {
            tree.bound(cluster);
        }
        tree
    }

    /// Appends a cluster with all clusters in it; its surfaces come later, at places that are known.
    fn add_cluster(&mut self, parts: &[Group; 2]) -> u32 {
        let index = self.nodes.len();
        self.nodes.push(Node::nothing(DVec3::ZERO));
        for part in parts {
            let child = match part {
                Group::One(surface) => (self.clusters + surface) as u32,
                Group::Two(parts) => self.add_cluster(parts),
            };
            self.nodes[index].children.push(child);
        }
        index as u32
    }

    /// Sets area and ball of a cluster from its children.
    fn bound(&mut self, cluster: usize) {
        let children: SmallVec<[usize; 4]> = self.children(cluster).collect();
        let corners = |child: &usize| {
            let Node { center, radius, .. } = self.nodes[*child];
            [center - DVec3::splat(radius), center + DVec3::splat(radius)]
        };
        let center = Aabb::around(children.iter().flat_map(corners)).center();
        let reach = |child: &usize| self.nodes[*child].center.distance(center) + self.nodes[*child].radius;
        let radius = children.iter().map(reach).fold(0.0, f64::max);
        let area = children.iter().map(|child| self.nodes[*child].area).sum();
        let node = &mut self.nodes[cluster];
        (node.center, node.radius, node.area) = (center, radius, area);
    }

    /// All nodes.
    pub(crate) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Number of clusters.
    pub(crate) fn clusters(&self) -> usize {
        self.clusters
    }

    /// Number of surfaces.
    pub(crate) fn surfaces(&self) -> usize {
        self.shapes.len()
    }

    /// The node of a whole surface.
    pub(crate) fn of_surface(&self, surface: usize) -> usize {
        self.clusters + surface
    }

    /// The children of a node.
    pub(crate) fn children(&self, node: usize) -> impl DoubleEndedIterator<Item = usize> + '_ {
        self.nodes[node].children.iter().map(|child| *child as usize)
    }

    /// Cuts a face that has no children into cells. Returns whether the node has children now.
    pub(crate) fn cut(&mut self, node: usize) -> bool {
        let Node { children, face, is_whole, area, .. } = &self.nodes[node];
        let (Some(face), false, true) = (face, *is_whole, children.is_empty()) else {
            return !children.is_empty();
        };
        let cells = face.cells(&self.shapes[face.surface]);
        if cells.is_empty() {
            self.nodes[node].is_whole = true;
            return false;
        }
        let areas: Vec<f64> = cells.iter().map(Face::patch_area).collect();
        let scale = area / areas.iter().sum::<f64>();
        for (cell, area) in cells.into_iter().zip(areas) {
            let child = self.nodes.len() as u32;
            self.nodes[node].children.push(child);
            self.nodes.push(face_node(cell, scale * area));
        }
        true
    }

    /// The leaves of a surface: faces that are not cut, depth first.
    pub(crate) fn leaves_of(&self, surface: usize) -> Vec<usize> {
        let (mut stack, mut leaves) = (vec![self.of_surface(surface)], Vec::new());
        while let Some(node) = stack.pop() {
            let has_face = self.nodes[node].face.is_some();
            (self.nodes[node].children.is_empty() && has_face).then(|| leaves.push(node));
            stack.extend(self.children(node).rev());
        }
        leaves
    }

    /// Cut of the cell `rect` of a surface; none if it is no node.
    pub(crate) fn cut_of(&self, surface: usize, rect: &Rect) -> CellRefinement {
        let [u, v] = rect.center();
        let mut node = self.of_surface(surface);
        while let Some(face) = &self.nodes[node].face {
            let part = self.children(node).find_map(|child| Some(self.nodes[child].face.as_ref()?.rect));
            let Some(part) = part else { break };
            if face.rect == *rect {
                return CellRefinement::Cut(match () {
                    () if part.u == rect.u => Some(Axis::V),
                    () if part.v == rect.v => Some(Axis::U),
                    () => None,
                });
            }
            let holds =
                |child: &usize| self.nodes[*child].face.as_ref().is_some_and(|face| face.rect.contains(u, v));
            let Some(child) = self.children(node).find(holds) else { break };
            node = child;
        }
        CellRefinement::Keep
    }

    /// The leaf of a surface that holds the parameters (u, v); None in a hole that fills a cell.
    pub(crate) fn leaf_at(&self, surface: usize, [u, v]: [f64; 2]) -> Option<usize> {
        let mut node = self.of_surface(surface);
        self.nodes[node].face.as_ref()?;
        while !self.nodes[node].children.is_empty() {
            let holds =
                |child: &usize| self.nodes[*child].face.as_ref().is_some_and(|face| face.rect.contains(u, v));
            node = self.children(node).find(holds)?;
        }
        Some(node)
    }
}

impl Node {
    /// A node that exchanges nothing.
    fn nothing(center: DVec3) -> Self {
        Self { children: smallvec![], area: 0.0, center, radius: 0.0, face: None, is_whole: true }
    }
}

fn face_node(mut face: Face, area: f64) -> Node {
    face.measure(area);
    let (center, radius) = face.ball();
    Node { children: smallvec![], area, center, radius, face: Some(Box::new(face)), is_whole: false }
}
