//! The oracle: whether a pair of nodes is linked, split or left out.
//!
//! With the areas a that the nodes show each other at most, the power that q sends to p is estimated from
//! above, without visibility, by that to a disc (Hanrahan, Salzman, Aupperle 1991)
//!
//! ```text
//! Φ ≤ B_q a_q a_p / (π r² + max(a_p, a_q)) ,    a = A min(1, h/r) ,    a = min(A, π R²) of a cluster ,
//! ```
//!
//! where h is the greatest height of the other node over the plane of a flat face. Weighted so by brightness
//! (Smits, Arvo, Salesin 1992) a pair is linked if Φ in both directions and in all bands is at most eps of
//! the power that the scene emits; unweighted, if both form factors F = Φ/(B_q A_q) are at most eps. A cluster
//! is linked only to nodes from which its ball keeps apart.

use std::f64::consts::PI;

use radiosity_geom::COINCIDENT;

use super::exchange::exchange;
use super::options::LinkMeasure;
use super::tree::{Node, Tree};

/// Verdict about a pair of different nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// One node lies behind the other.
    FacesAway,
    /// One link carries the pair.
    Link,
    /// The larger node is to be split, or the other one.
    Split,
}

/// When pairs are linked.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Oracle {
    /// The measure that is compared with `eps`.
    pub measure: LinkMeasure,
    /// Greatest power of a link, in parts of the emitted power, or its greatest form factor.
    pub eps: f64,
    /// Least distance of the centres of linked nodes of which one is a cluster, in sums of the radii.
    pub separation: f64,
}

impl Oracle {
    /// The verdict about two nodes; `light` tells of a node the power that it sends (B A per band, in parts
    /// of the emitted power).
    pub(crate) fn judge(&self, tree: &Tree, light: &[Vec<f64>], [p, q]: [usize; 2]) -> Verdict {
        let nodes = [p, q].map(|node| &tree.nodes()[node]);
        let [first, second] = nodes;
        let heights = [height(first, second), height(second, first)];
        let flush = COINCIDENT * (first.radius + second.radius);
        if heights.iter().any(|height| *height <= flush) || first.area * second.area == 0.0 {
            return Verdict::FacesAway;
        }
        let distance = first.center.distance(second.center);
        let apart = distance >= self.separation * (first.radius + second.radius);
        if !apart && nodes.iter().any(|node| node.face.is_none()) {
            return Verdict::Split;
        }
        let cosines = [0, 1].map(|k| cosine(nodes[k], heights[k], distance));
        let shown = [0, 1].map(|k| cosines[k] * shown(nodes[k]));
        let sphere = PI * distance.powi(2) + shown[0].max(shown[1]);
        let sent = |k: usize| self.weight(light, [q, p][k]) * cosines[1 - k] * shown[k] / sphere;
        if sent(0).max(sent(1)) <= self.eps { Verdict::Link } else { Verdict::Split }
    }

    /// Whether the light that a face sends to itself is carried by one link.
    pub(crate) fn links_itself(&self, tree: &Tree, light: &[Vec<f64>], node: usize) -> bool {
        let form_factor = match (&tree.nodes()[node].face, self.measure) {
            (Some(face), LinkMeasure::FormFactor) => exchange(face, face) / tree.nodes()[node].area,
            _ => 1.0,
        };
        self.weight(light, node) * form_factor <= self.eps
    }

    /// Weight of the form factors from a node: its power, the greatest over the bands, or 1.
    fn weight(&self, light: &[Vec<f64>], node: usize) -> f64 {
        match self.measure {
            LinkMeasure::Power => light.iter().map(|band| band[node]).fold(0.0, f64::max),
            LinkMeasure::FormFactor => 1.0,
        }
    }
}

/// Greatest height of `other` over the plane of `node`; without bound where this is not flat.
fn height(node: &Node, other: &Node) -> f64 {
    let Some(normal) = node.face.as_ref().and_then(|face| face.normal) else { return f64::INFINITY };
    match &other.face {
        Some(face) if face.normal.is_some() => {
            face.hull.iter().map(|x| (x - node.center).dot(normal)).fold(f64::NEG_INFINITY, f64::max)
        }
        _ => (other.center - node.center).dot(normal) + other.radius,
    }
}

/// Greatest cosine between the normal of a flat face and the direction to the other node, about; 1 for
/// others.
fn cosine(node: &Node, height: f64, distance: f64) -> f64 {
    let is_flat = node.face.as_ref().is_some_and(|face| face.normal.is_some());
    if is_flat { (height / distance).min(1.0) } else { 1.0 }
}

/// The area that a node shows at most from its front (scene length²).
fn shown(node: &Node) -> f64 {
    let is_flat = node.face.as_ref().is_some_and(|face| face.normal.is_some());
    if is_flat { node.area } else { node.area.min(PI * node.radius.powi(2)) }
}
