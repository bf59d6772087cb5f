//! Coarse estimate of the transfer between two elements, by few points:
//!
//! ```text
//! G_00 ≈ Σ_a Σ_b w_a w_b κ(x_a, y_b) / √(A_i A_j) ,
//! ```
//!
//! with the nodes at the centres of the cells of uniform grids. The two sides have different numbers of
//! nodes, so that nodes at a contact do not coincide.

use radiosity_elements::Element;
use radiosity_elements::measure::WeightedNode;
use radiosity_elements::patch::{Node, Patch};
use radiosity_work::interruption::check_interrupt;

use crate::contact::sectors::sectors;
use crate::moments::integrand::{Sees, kernel};

/// Points per direction of a part, for the receiver and the emitter: few, since those who use the estimate
/// allow it to be off by a factor of two or three, and the time grows with their fourth power.
const POINTS: [usize; 2] = [4, 5];
/// Points per direction of a part, for the receiver and the emitter, on elements of more than [`MANY_PARTS`]
/// parts, which have enough points together.
const FEWER_POINTS: [usize; 2] = [2, 3];
/// Parts of an element above which each gets [`FEWER_POINTS`].
const MANY_PARTS: usize = 4;
/// Points per direction of the grids that reach the corners. An arbitrary choice: with fewer a small part
/// that is seen is missed, the time grows with their fourth power.
const CORNERED: usize = 6;

/// The nodes of an element.
#[derive(Debug)]
pub struct CoarseEstimate {
    /// Nodes in the role of the receiver and of the emitter.
    nodes: [Vec<WeightedNode>; 2],
    area: f64,
}

impl CoarseEstimate {
    /// The points of an element.
    pub fn of(element: &Element) -> Self {
        check_interrupt();
        let parts = sectors(element);
        let points = if parts.len() > MANY_PARTS { FEWER_POINTS } else { POINTS };
        Self { nodes: points.map(|n| weighted(&parts, n)), area: element.area }
    }

    /// Coarse estimate of the first entry of the block of this receiver and an emitter, without blockers;
    /// capped by ∫κ dA ≤ 1 on either side.
    pub fn entry(&self, emitter: &Self) -> f64 {
        let unit = (self.area * emitter.area).sqrt();
        let most = self.area.min(emitter.area) / unit;
        (sum(&self.nodes[0], &emitter.nodes[1]) / unit).min(most)
    }

    /// The number of pairs of nodes that face each other, if all of them are hidden.
    pub fn hidden_rays(&self, emitter: &Self, sees: Sees) -> Option<u64> {
        let mut rays = 0;
        for x in self.nodes[0].iter().map(|x| &x.node) {
            for y in emitter.nodes[1].iter().map(|y| &y.node).filter(|y| kernel(x, y) > 0.0) {
                rays += 1;
                if sees(x.position, y.position) {
                    return None;
                }
            }
        }
        Some(rays)
    }
}

/// Coarse estimate of ∫∫ κ dA dA / `unit`, at most 1.
pub fn scale(receivers: &[Patch], emitters: &[Patch], unit: f64) -> f64 {
    let [few, more] = POINTS;
    (sum(&weighted(receivers, few), &weighted(emitters, more)) / unit).min(1.0)
}

/// The largest kernel value between grids that reach the corners of the patches: corners may see each other
/// where nothing else does.
pub fn largest_kernel(receivers: &[Patch], emitters: &[Patch]) -> f64 {
    let place = |k: usize| k as f64 / (CORNERED - 1) as f64;
    let grid = |patch: &Patch| -> Vec<Node> {
        (0..CORNERED * CORNERED).map(|k| patch.node(place(k / CORNERED), place(k % CORNERED))).collect()
    };
    let emitters: Vec<Node> = emitters.iter().flat_map(grid).collect();
    let receivers = receivers.iter().flat_map(grid);
    receivers.flat_map(|x| emitters.iter().map(move |y| kernel(&x, y))).fold(0.0, f64::max)
}

fn sum(receivers: &[WeightedNode], emitters: &[WeightedNode]) -> f64 {
    let row = |x: &Node| emitters.iter().map(|y| y.weight * kernel(x, &y.node)).sum::<f64>();
    receivers.iter().map(|x| x.weight * row(&x.node)).sum()
}

/// The n × n nodes of each patch, each with the area of its cell.
fn weighted(patches: &[Patch], n: usize) -> Vec<WeightedNode> {
    let cell = |node: Node| WeightedNode { node, weight: node.area / (n * n) as f64 };
    patches.iter().flat_map(|patch| patch.cell_nodes(n).into_iter().map(cell)).collect()
}
