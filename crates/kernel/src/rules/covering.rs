//! Two flat elements that lie on each other ([`radiosity_visibility::covered_parts`]): each point exchanges
//! light with the one it touches.
//!
//! ```text
//! κ(x, y) dA_y → δ(x − y) ,     G_kl = ∫ φ_k(x) φ_l(x) dA_x .
//! ```
//!
//! The Gauss rule is exact: n points integrate degree 2n − 1, the product of two polynomials and a bilinear
//! area element.
//!
//! Error. Of two elements a gap of the height h apart, whose common border has the length P, ½ h P of the
//! exchange leaves through the gap, to first order: along a straight border the part ½ (1 − s/√(s² + h²)) of
//! what is sent at the distance s from it.

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{COINCIDENT, DVec3, sides};

use crate::blocks::block::{Block, PairKind};
use crate::moments::Moments;

/// The block of two elements of which one covers the other.
pub fn block(receiver: &Element, emitter: &Element) -> Block {
    let (rows, columns) = (receiver.basis.len(), emitter.basis.len());
    let rule = UnitRule::of((receiver.basis.total_degree() + emitter.basis.total_degree()) / 2 + 2);
    let (mut sum, mut samples) = (vec![0.0; rows * columns], 0);
    for patch in &receiver.patches {
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let node = patch.node(s, t);
            let parameters = node.parameters.to_array();
            let own = receiver.raw_values(node.position, parameters);
            let other = emitter.raw_values(node.position, parameters);
            for (row, l) in sum.chunks_exact_mut(columns).zip(own) {
                row.iter_mut().zip(&other).for_each(|(value, r)| *value += ws * wt * node.area * l * r);
            }
            samples += 1;
        }
    }
    let mut moments = Moments::new(&receiver.basis, &emitter.basis);
    moments.add_raw(&sum, samples);
    let mut block = Block::of(moments, PairKind::Contact, false);
    block.report.error = lost(receiver, emitter) / (receiver.area * emitter.area).sqrt();
    block.report.told = block.values[0];
    block
}

/// Exchange that the gap between two elements lets out (length²).
fn lost(receiver: &Element, emitter: &Element) -> f64 {
    let Some(plane) = emitter.plane else { return 0.0 };
    let corners = receiver.patches.iter().flat_map(Patch::polygon);
    let gap = corners.map(|x| plane.height(x).abs()).fold(0.0, f64::max);
    0.5 * gap * border(&receiver.patches, COINCIDENT * receiver.extent)
}

/// Length of the border of disjoint flat patches: sides of two of them, nearer to each other than
/// `tolerance`, are none.
fn border(patches: &[Patch], tolerance: f64) -> f64 {
    let all: Vec<[DVec3; 2]> =
        patches.iter().flat_map(|patch| sides(&patch.polygon()).collect::<Vec<_>>()).collect();
    let whole: f64 = all.iter().map(|[a, b]| a.distance(*b)).sum();
    let pairs = all
        .iter()
        .enumerate()
        .flat_map(|(place, side)| all[place + 1..].iter().map(move |other| (side, other)));
    whole - 2.0 * pairs.map(|(side, other)| common(*side, *other, tolerance)).sum::<f64>()
}

/// Length that two sides have in common, which run against each other.
fn common([a, b]: [DVec3; 2], [c, d]: [DVec3; 2], tolerance: f64) -> f64 {
    let along = (b - a).normalize_or_zero();
    let off = |x: DVec3| (x - a - (x - a).dot(along) * along).length();
    if along.dot(d - c) >= 0.0 || off(c).max(off(d)) > tolerance {
        return 0.0;
    }
    let [from, to] = [d, c].map(|x| (x - a).dot(along));
    (to.min(a.distance(b)) - from.max(0.0)).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_border_of_parts_leaves_out_what_they_share() {
        let rectangle = |[x0, x1]: [f64; 2], [y0, y1]: [f64; 2]| Patch::Flat {
            corners: [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(|[x, y]| DVec3::new(x, y, 0.0)),
            normal: DVec3::Z,
        };
        let (left, low, high) =
            (rectangle([0., 1.], [0., 2.]), rectangle([1., 3.], [0., 1.]), rectangle([1., 3.], [1., 2.]));
        assert!((border(&[left, low, high], 1e-9) - 10.0).abs() < 1e-12);
    }
}
