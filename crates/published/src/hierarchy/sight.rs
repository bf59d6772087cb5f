//! Visibility of a link: the part of its exchange that nothing hides, by rays.
//!
//! ```text
//! V = Σ_k κ(x_k, y_k) v(x_k, y_k) / Σ_k κ(x_k, y_k) ,     κ = cos⁺ cos⁺ / (π r²)
//! ```
//!
//! over quasi-random pairs of points, spread by area over the surfaces of either node. Pairs with κ = 0 cast
//! no ray. The points follow from the numbers of the nodes alone, so that no thread changes a bit.

use radiosity_elements::measure::WeightedNode;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::{shift, shifted};
use radiosity_geom::RayTree;
use radiosity_kernel::kernel;
use radiosity_visibility::tolerances::OWN_END;

use super::tree::Tree;

/// Pairs of points that are tried for each ray that is wanted, since some do not face each other. With more,
/// pairs of nodes that hardly see each other get more rays.
const TRIES: u64 = 4;

/// The part of the exchange of two nodes that is not hidden, by `rays` rays or fewer; 0 where no pair of
/// points faces each other.
pub(crate) fn visible_part(tree: &Tree, obstacles: &RayTree, [p, q]: [usize; 2], rays: usize) -> f64 {
    let shift = shift::<4>((p as u64) << 32 | q as u64);
    let (mut all, mut free, mut cast) = (0.0, 0.0, 0);
    for index in 0..TRIES * rays as u64 {
        let [a, b, c, d] = shifted(kronecker::point::<4>(index), &shift);
        let (x, y) = (place(tree, p, [a, b]), place(tree, q, [c, d]));
        let Some(((surface, x), (_, y))) = x.zip(y) else { break };
        let weight = x.weight * y.weight * kernel(&x.node, &y.node);
        if weight <= 0.0 || !weight.is_finite() {
            continue;
        }
        let (start, end) = (x.node.position, y.node.position);
        let is_free = obstacles.is_free_from(surface, start, end - start, 1.0 - OWN_END);
        all += weight;
        free += if is_free { weight } else { 0.0 };
        cast += 1;
        if cast == rays {
            break;
        }
    }
    if all > 0.0 { free / all } else { 0.0 }
}

/// The point of a node that two numbers in [0, 1) choose, evenly by area, and its surface.
fn place(tree: &Tree, mut node: usize, [mut s, t]: [f64; 2]) -> Option<(usize, WeightedNode)> {
    while tree.nodes()[node].face.is_none() {
        let mut left = s * tree.nodes()[node].area;
        let (last, others) = tree.nodes()[node].children.split_last()?;
        let mut chosen = *last as usize;
        for child in others {
            let area = tree.nodes()[*child as usize].area;
            if left < area {
                chosen = *child as usize;
                break;
            }
            left -= area;
        }
        s = (left / tree.nodes()[chosen].area).clamp(0.0, 1.0);
        node = chosen;
    }
    let face = tree.nodes()[node].face.as_ref()?;
    Some((face.surface, face.area_map.point([s, t])))
}
