//! Pairs of points spread evenly over two patches.

use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::sampling::kronecker;

/// The pair of points number `index` of the Kronecker sequence in [0, 1]⁴, one on either patch.
pub fn node_pair([p, q]: [&Patch; 2], index: u64) -> [Node; 2] {
    let [s, t, u, v] = kronecker::point(index);
    [p.node(s, t), q.node(u, v)]
}
