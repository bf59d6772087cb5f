//! Pairs of points spread evenly over two patches: a Kronecker sequence in [0, 1]⁴.
//!
//! ```text
//! z_m = fract(½ + m a) ,     a_d = g⁻ᵈ ,   g⁵ = g + 1 .
//! ```
//!
//! Reference: M. Roberts, *The unreasonable effectiveness of quasirandom sequences* (2018): generalised golden ratio.

use crate::elements::patch::{Node, Patch};

/// Powers of 1/g, g⁵ = g + 1.
const STEPS: [f64; 4] =
    [0.856_674_883_854_502_9, 0.733_891_856_627_125_9, 0.628_706_721_037_808_7, 0.538_597_257_282_365_9];

/// Point number `index` of the sequence.
pub(in crate::transport) fn point(index: u64) -> [f64; 4] {
    STEPS.map(|step| (0.5 + index as f64 * step).fract())
}

/// The pair of points number `index` of the sequence, one on either patch.
pub(in crate::transport) fn node_pair([p, q]: [&Patch; 2], index: u64) -> [Node; 2] {
    let [s, t, u, v] = point(index);
    [p.node(s, t), q.node(u, v)]
}
