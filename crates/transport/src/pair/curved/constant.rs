//! Pairs on which the kernel is constant: two parts of the inside of one sphere.
//!
//! ```text
//! ∫∫ κ φ_k φ_l = κ ∫ φ_k dA ∫ φ_l dA
//! ```

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_kernel::kernel;
use radiosity_kernel::rules::orders::chart_orders;

use crate::pair::job::Job;

impl Job<'_> {
    /// Adds a pair of patches with a constant kernel: the product of their own moments.
    pub(super) fn constant(&mut self, p: &Patch, q: &Patch, value: f64) {
        let side = |patch: &Patch, element: &Element| {
            let basis = &element.basis;
            let (mut sums, mut row) = (vec![0.0; basis.len()], vec![0.0; basis.len()]);
            let [along, across] = chart_orders::points(patch, self.budget.accuracy.eps)
                .map(|n| UnitRule::of(basis.order() / 2 + n + 2));
            for ((s, ws), (t, wt)) in along.iter().flat_map(|s| across.iter().map(move |t| (s, t))) {
                let node = patch.node(s, t);
                basis.raw(basis.frame().coordinates(&node), &mut row);
                sums.iter_mut().zip(&row).for_each(|(sum, l)| *sum += ws * wt * node.area * l);
            }
            (sums, (along.nodes.len() * across.nodes.len()) as u64)
        };
        let ((left, m), (right, n)) = (side(p, self.elements[0]), side(q, self.elements[1]));
        let moments: Vec<f64> = left.iter().flat_map(|l| right.iter().map(move |r| value * l * r)).collect();
        self.moments.add_raw(&moments, m + n);
    }
}

/// The kernel's value if it is the same, to 1e-10, at 9 × 16 pairs of points: both patches lie on the inside
/// of one sphere.
pub(super) fn constant(p: &Patch, q: &Patch) -> Option<f64> {
    if p.is_flat() || q.is_flat() {
        return None;
    }
    let (a, b) = (p.cell_nodes(3), q.cell_nodes(4));
    let values = a.iter().flat_map(|x| b.iter().map(move |y| kernel(x, y)));
    let [low, high] = values.fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], k| [low.min(k), high.max(k)]);
    (low > 0.0 && high - low <= 1e-10 * high).then_some(0.5 * (low + high))
}
