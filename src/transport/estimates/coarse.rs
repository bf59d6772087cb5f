//! About what two elements exchange, by few points: how large blocks are is known before they are integrated.
//!
//! ```text
//! G_00 ≈ Σ_a Σ_b w_a w_b κ(x_a, y_b) / √(A_i A_j) ,
//! ```
//!
//! with the nodes at the middles of the cells of uniform grids, other numbers of them on either side so that points of
//! contact do not meet.

use crate::elements::Element;
use crate::elements::patch::{Node, Patch};

use crate::transport::contact::sectors::sectors;
use crate::transport::moments::integrand::{Sees, kernel};

/// Points a direction on either side.
const POINTS: [usize; 2] = [4, 5];
/// The same for elements of more than so many parts.
const FEWER_POINTS: [usize; 2] = [2, 3];
const MANY_PARTS: usize = 4;
/// Points a direction of grids with points at the corners.
const CORNERED: usize = 6;

/// An element ready to be set against others.
#[derive(Debug)]
pub(in crate::transport) struct CoarseEstimate {
    /// Nodes with weights for the part of the receiver and that of the emitter.
    nodes: [Vec<(Node, f64)>; 2],
    area: f64,
}

impl CoarseEstimate {
    /// Of one element.
    pub(in crate::transport) fn of(element: &Element) -> Self {
        let parts = sectors(element);
        let points = if parts.len() > MANY_PARTS { FEWER_POINTS } else { POINTS };
        Self { nodes: points.map(|n| weighted(&parts, n)), area: element.area }
    }

    /// About the first entry of the block of this receiver and another emitter, with nothing in between; no more than
    /// ∫κ dA ≤ 1 on either side allows.
    pub(in crate::transport) fn entry(&self, emitter: &Self) -> f64 {
        let unit = (self.area * emitter.area).sqrt();
        let most = self.area.min(emitter.area) / unit;
        (sum(&self.nodes[0], &emitter.nodes[1]) / unit).min(most)
    }

    /// The number of pairs of nodes that face each other, if all of them are hidden from each other.
    pub(in crate::transport) fn hidden_rays(&self, emitter: &Self, sees: Sees) -> Option<u64> {
        let mut rays = 0;
        for (x, _) in &self.nodes[0] {
            for (y, _) in emitter.nodes[1].iter().filter(|(y, _)| kernel(x, y) > 0.0) {
                rays += 1;
                if sees(x.position, y.position) {
                    return None;
                }
            }
        }
        Some(rays)
    }
}

/// About ∫∫κ over `unit`.
pub(in crate::transport) fn scale(receivers: &[Patch], emitters: &[Patch], unit: f64) -> f64 {
    let [few, more] = POINTS;
    (sum(&weighted(receivers, few), &weighted(emitters, more)) / unit).min(1.0)
}

/// The largest value of the kernel between the points of grids that reach to the corners, which may see each other though no
/// other points do.
pub(in crate::transport) fn largest_kernel(receivers: &[Patch], emitters: &[Patch]) -> f64 {
    let place = |k: usize| k as f64 / (CORNERED - 1) as f64;
    let grid = |patch: &Patch| -> Vec<Node> {
        (0..CORNERED * CORNERED).map(|k| patch.node(place(k / CORNERED), place(k % CORNERED))).collect()
    };
    let emitters: Vec<Node> = emitters.iter().flat_map(grid).collect();
    let receivers = receivers.iter().flat_map(grid);
    receivers.flat_map(|x| emitters.iter().map(move |y| kernel(&x, y))).fold(0.0, f64::max)
}

fn sum(receivers: &[(Node, f64)], emitters: &[(Node, f64)]) -> f64 {
    let row = |x: &Node| emitters.iter().map(|(y, wy)| wy * kernel(x, y)).sum::<f64>();
    receivers.iter().map(|(x, wx)| wx * row(x)).sum()
}

/// n × n nodes a patch, each with the area of its cell.
fn weighted(patches: &[Patch], n: usize) -> Vec<(Node, f64)> {
    let cell = |x: Node| {
        let area = x.area / (n * n) as f64;
        (x, area)
    };
    patches.iter().flat_map(|patch| patch.cell_nodes(n).into_iter().map(cell)).collect()
}
