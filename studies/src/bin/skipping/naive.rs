//! The naive program: every kernel sample times its visibility.

use radiosity::elements::Element;
use radiosity::elements::patch::{Node, Patch};
use radiosity::elements::rule::UnitRule;
use radiosity::kernel::kernel;
use radiosity::visibility::Visibility;
use radiosity_geom::Ray;
use smallvec::SmallVec;

/// A ray may touch surfaces within this part of its length at both ends.
const END: f64 = 1e-6;

/// Powers of 1/g, g⁵ = g + 1, and where the sequence begins.
const STEPS: [f64; 4] =
    [0.856_674_883_854_502_9, 0.733_891_856_627_125_9, 0.628_706_721_037_808_7, 0.538_597_257_282_365_9];
const BEGIN: [f64; 4] = [0.137, 0.762, 0.391, 0.918];

/// S by `points` points of a Kronecker sequence in [0, 1]⁴ for each pair of patches: no rule for the kernel,
/// and no grid.
pub(crate) fn scattered(
    [receiver, emitter]: [&Element; 2],
    visibility: &Visibility,
    points: usize,
) -> Vec<f64> {
    let mut sum = Sum::new(receiver, emitter);
    let place = |k: usize, d: usize| (BEGIN[d] + (k as f64 * STEPS[d]).fract()).fract();
    for (p, q) in receiver.patches.iter().flat_map(|p| emitter.patches.iter().map(move |q| (p, q))) {
        for k in 0..points {
            let (x, y) = (p.node(place(k, 0), place(k, 1)), q.node(place(k, 2), place(k, 3)));
            let value = x.area * y.area * kernel(&x, &y) / points as f64;
            if value > 0.0 && is_hidden(visibility, &x, &y) {
                sum.add(value, &sum.left(&x), &sum.right(&y));
            }
        }
    }
    sum.block()
}

/// S by an n⁴ rule, each sample times what is hidden there.
pub(crate) fn shade(
    [receiver, emitter]: [&Element; 2],
    visibility: &Visibility,
    n: usize,
    rays: &mut u64,
) -> Vec<f64> {
    let mut sum = Sum::new(receiver, emitter);
    let points = |element: &Element| -> Vec<(Node, f64)> {
        element.patches.iter().flat_map(|patch| nodes(patch, n)).collect()
    };
    let (xs, ys) = (points(receiver), points(emitter));
    let rights: Vec<_> = ys.iter().map(|(y, _)| sum.right(y)).collect();
    for (x, wx) in &xs {
        let left = sum.left(x);
        for ((y, wy), right) in ys.iter().zip(&rights) {
            let value = wx * wy * kernel(x, y);
            if value == 0.0 {
                continue;
            }
            *rays += 1;
            if is_hidden(visibility, x, y) {
                sum.add(value, &left, right);
            }
        }
    }
    sum.block()
}

fn is_hidden(visibility: &Visibility, x: &Node, y: &Node) -> bool {
    let direction = y.position - x.position;
    let ray = Ray { origin: x.position, direction, range: [END, 1.0 - END] };
    visibility.nearest(&ray).is_some()
}

/// A block by its moments in raw polynomials.
struct Sum<'a> {
    receiver: &'a Element,
    emitter: &'a Element,
    moments: Vec<f64>,
}

impl<'a> Sum<'a> {
    fn new(receiver: &'a Element, emitter: &'a Element) -> Self {
        Self { receiver, emitter, moments: vec![0.0; receiver.basis.len() * emitter.basis.len()] }
    }

    fn left(&self, x: &Node) -> SmallVec<[f64; 28]> {
        self.receiver.raw_values(x.position, x.parameters.to_array())
    }

    fn right(&self, y: &Node) -> SmallVec<[f64; 28]> {
        self.emitter.raw_values(y.position, y.parameters.to_array())
    }

    fn add(&mut self, value: f64, left: &[f64], right: &[f64]) {
        for (row, l) in self.moments.chunks_exact_mut(right.len()).zip(left) {
            row.iter_mut().zip(right).for_each(|(sum, r)| *sum += value * l * r);
        }
    }

    fn block(&self) -> Vec<f64> {
        transformed(&self.moments, self.receiver.basis.transform(), self.emitter.basis.transform())
    }
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
