//! Two flat elements that lie on each other ([`radiosity_visibility::covered_parts`]): each point exchanges
//! light with the one it touches.
//!
//! ```text
//! κ(x, y) dA_y → δ(x − y) ,     G_kl = ∫ φ_k(x) φ_l(x) dA_x .
//! ```
//!
//! The Gauss rule is exact: n points integrate degree 2n − 1, the product of two polynomials and a bilinear
//! area element.

use radiosity_elements::Element;
use radiosity_elements::rule::UnitRule;

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
    Block::of(moments, PairKind::Contact, false)
}
