//! The naive program: every kernel sample times its visibility.

use radiosity::elements::Element;
use radiosity::elements::patch::{Node, Patch};
use radiosity::elements::rule::UnitRule;
use radiosity::kernel::kernel;
use radiosity::visibility::Visibility;
use radiosity_geom::Ray;

/// A ray may touch surfaces within this part of its length at both ends.
const END: f64 = 1e-6;

/// S by an n⁴ rule, each sample times what is hidden there.
pub(crate) fn shade(
    [receiver, emitter]: [&Element; 2],
    visibility: &Visibility,
    n: usize,
    rays: &mut u64,
) -> Vec<f64> {
    let (rows, columns) = (receiver.basis.len(), emitter.basis.len());
    let mut moments = vec![0.0; rows * columns];
    let points = |element: &Element| -> Vec<(Node, f64)> {
        element.patches.iter().flat_map(|patch| nodes(patch, n)).collect()
    };
    let (xs, ys) = (points(receiver), points(emitter));
    let raw = |element: &Element, node: &Node| element.raw_values(node.position, node.parameters.to_array());
    let rights: Vec<_> = ys.iter().map(|(y, _)| raw(emitter, y)).collect();
    for (x, wx) in &xs {
        let left = raw(receiver, x);
        for ((y, wy), right) in ys.iter().zip(&rights) {
            let value = wx * wy * kernel(x, y);
            if value == 0.0 {
                continue;
            }
            *rays += 1;
            let direction = y.position - x.position;
            let ray = Ray { origin: x.position, direction, range: [END, 1.0 - END] };
            if visibility.nearest(&ray).is_some() {
                for (row, l) in moments.chunks_exact_mut(columns).zip(&left) {
                    row.iter_mut().zip(right).for_each(|(sum, r)| *sum += value * l * r);
                }
            }
        }
    }
    transformed(&moments, receiver.basis.transform(), emitter.basis.transform())
}

/// T_i M T_jᵀ, T lower triangular.
fn transformed(moments: &[f64], receiver: &[f64], emitter: &[f64]) -> Vec<f64> {
    let columns = (emitter.len() as f64).sqrt() as usize;
    let rows = moments.len() / columns;
    let entry = |k: usize, l: usize| -> f64 {
        let terms = (0..rows).flat_map(|a| (0..columns).map(move |b| (a, b)));
        terms.map(|(a, b)| receiver[k * rows + a] * moments[a * columns + b] * emitter[l * columns + b]).sum()
    };
    (0..rows * columns).map(|index| entry(index / columns, index % columns)).collect()
}

/// Nodes of the n × n Gauss rule on a patch, with their weights.
fn nodes(patch: &Patch, n: usize) -> Vec<(Node, f64)> {
    let rule = UnitRule::of(n);
    let product = rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t)));
    let node = |((s, ws), (t, wt)): ((f64, f64), (f64, f64))| {
        let node = patch.node(s, t);
        let weight = ws * wt * node.area;
        (node, weight)
    };
    product.map(node).collect()
}
