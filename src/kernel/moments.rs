//! Moments of the kernel between two patches, in the raw polynomials of their elements:
//!
//! ```text
//! M_kl += Σ_ab  w_a A_a w_b A_b κ(x_a, y_b) V(x_a, y_b) L_k(x_a) L_l(y_b) ,      G = T_i M T_jᵀ .
//! ```
//!
//! Tensor rules contract one side at a time: W_al = Σ_b κ_ab L_l(y_b), then Σ_a L_k(x_a) W_al, so a
//! kernel sample costs one row of the emitter's table, not a product of two.

use radiosity_geom::DVec3;

use super::integrand::kernel;
use super::own::Change;
use crate::elements::basis::AreaBasis;
use crate::elements::patch::{Node, Patch};
use crate::elements::rule::UnitRule;

/// Whether the segment between two points is free.
pub(super) type Sees<'a> = &'a dyn Fn(DVec3, DVec3) -> bool;

/// Moments of one pair of elements under way.
#[derive(Debug)]
pub(super) struct Moments<'a> {
    receiver: &'a AreaBasis,
    emitter: &'a AreaBasis,
    /// M, row-major, receiver functions by emitter functions.
    values: Vec<f64>,
    row: Vec<f64>,
    column: Vec<f64>,
    /// Terms of the rules so far.
    pub samples: u64,
    /// Kernel evaluations so far: less than the terms where the kernel is known to repeat.
    pub distinct: u64,
    /// Segments tested for visibility so far.
    pub rays: u64,
}

impl<'a> Moments<'a> {
    /// No moments yet.
    pub(super) fn new(receiver: &'a AreaBasis, emitter: &'a AreaBasis) -> Self {
        let (rows, columns) = (receiver.len(), emitter.len());
        Self {
            receiver,
            emitter,
            values: vec![0.0; rows * columns],
            row: vec![0.0; rows],
            column: vec![0.0; columns],
            samples: 0,
            distinct: 0,
            rays: 0,
        }
    }

    /// Adds the tensor Gauss rule with `points` = [along, across] of the receiver, then the emitter.
    pub(super) fn tensor(&mut self, p: &Patch, q: &Patch, points: [usize; 4], sees: Option<Sees>) {
        let receiver = Table::new(p, self.receiver, [points[0], points[1]]);
        let emitter = Table::new(q, self.emitter, [points[2], points[3]]);
        let (rows, columns) = (self.row.len(), self.column.len());
        for (x, left) in receiver.nodes.iter().zip(receiver.rows.chunks_exact(rows)) {
            self.column.fill(0.0);
            for (y, right) in emitter.nodes.iter().zip(emitter.rows.chunks_exact(columns)) {
                let value = visible_kernel(x, y, sees, &mut self.rays);
                if value != 0.0 {
                    self.column.iter_mut().zip(right).for_each(|(w, l)| *w += value * l);
                }
            }
            rank_one(&mut self.values, left, &self.column);
        }
        let terms = (receiver.nodes.len() * emitter.nodes.len()) as u64;
        self.samples += terms;
        self.distinct += terms;
    }

    /// Adds one pair of points with a weight for the two charts.
    pub(super) fn scattered(&mut self, x: &Node, y: &Node, weight: f64, sees: Option<Sees>) {
        self.samples += 1;
        self.distinct += 1;
        let value = visible_kernel(x, y, sees, &mut self.rays) * weight * x.area * y.area;
        if value == 0.0 {
            return;
        }
        self.receiver.raw(self.receiver.frame().coordinates(x), &mut self.row);
        self.emitter.raw(self.emitter.frame().coordinates(y), &mut self.column);
        self.row.iter_mut().for_each(|left| *left *= value);
        rank_one(&mut self.values, &self.row, &self.column);
    }

    /// Adds moments given in the own polynomials of two parallelograms, receiver's index first.
    pub(super) fn own(&mut self, p: &Patch, q: &Patch, own: &[f64]) {
        let (rows, columns) = (self.row.len(), self.column.len());
        let half = Change::new(p, self.receiver).rows(own, columns);
        let whole = Change::new(q, self.emitter).rows(&transposed(&half, columns), rows);
        let back = transposed(&whole, rows);
        self.values.iter_mut().zip(&back).for_each(|(value, own)| *value += own);
    }

    /// Adds moments in the raw polynomials that took `samples` evaluations; `swapped`: emitter's index first.
    pub(super) fn add(&mut self, moments: &[f64], swapped: bool, samples: u64) {
        let turned = if swapped { transposed(moments, self.row.len()) } else { moments.to_vec() };
        self.values.iter_mut().zip(&turned).for_each(|(value, moment)| *value += moment);
        self.samples += samples;
        self.distinct += samples;
    }

    /// Largest difference of the raw moments of two sums of the same elements.
    pub(super) fn difference(&self, other: &Self) -> f64 {
        self.values.iter().zip(&other.values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    /// Adds another sum of the same elements, if `kept`; its cost in any case.
    pub(super) fn merge(&mut self, other: &Self, kept: bool) {
        if kept {
            self.values.iter_mut().zip(&other.values).for_each(|(value, moment)| *value += moment);
        }
        self.samples += other.samples;
        self.distinct += other.distinct;
        self.rays += other.rays;
    }

    /// G = T_i M T_jᵀ, row-major.
    pub(super) fn into_block(self) -> Vec<f64> {
        let (rows, columns) = (self.row.len(), self.column.len());
        let mut half = vec![0.0; rows * columns];
        for (k, out) in half.chunks_exact_mut(columns).enumerate() {
            let transform = &self.receiver.transform()[k * rows..=k * rows + k];
            for (t, moments) in transform.iter().zip(self.values.chunks_exact(columns)) {
                out.iter_mut().zip(moments).for_each(|(g, m)| *g += t * m);
            }
        }
        let mut block = vec![0.0; rows * columns];
        for (out, row) in block.chunks_exact_mut(columns).zip(half.chunks_exact(columns)) {
            for (l, g) in out.iter_mut().enumerate() {
                let transform = &self.emitter.transform()[l * columns..=l * columns + l];
                *g = transform.iter().zip(row).map(|(t, m)| t * m).sum();
            }
        }
        block
    }
}

/// Points of a tensor rule on a patch, and a row of w A L_k for each.
struct Table {
    nodes: Vec<Node>,
    rows: Vec<f64>,
}

impl Table {
    fn new(patch: &Patch, basis: &AreaBasis, points: [usize; 2]) -> Self {
        let count = basis.len();
        let (along, across) = (UnitRule::of(points[0]), UnitRule::of(points[1]));
        let total = along.nodes.len() * across.nodes.len();
        let mut nodes = Vec::with_capacity(total);
        let mut rows = vec![0.0; total * count];
        let product = along.iter().flat_map(|s| across.iter().map(move |t| (s, t)));
        for (((s, ws), (t, wt)), row) in product.zip(rows.chunks_exact_mut(count)) {
            let node = patch.node(s, t);
            basis.raw(basis.frame().coordinates(&node), row);
            row.iter_mut().for_each(|value| *value *= ws * wt * node.area);
            nodes.push(node);
        }
        Self { nodes, rows }
    }
}

/// κ V, with the ray cast only where κ does not vanish already.
#[inline]
fn visible_kernel(x: &Node, y: &Node, sees: Option<Sees>, rays: &mut u64) -> f64 {
    let value = kernel(x, y);
    match sees {
        Some(sees) if value > 0.0 => {
            *rays += 1;
            if sees(x.position, y.position) { value } else { 0.0 }
        }
        _ => value,
    }
}

/// A row-major matrix of `columns` columns, turned over.
fn transposed(matrix: &[f64], columns: usize) -> Vec<f64> {
    (0..columns).flat_map(|l| matrix.iter().skip(l).step_by(columns).copied()).collect()
}

fn rank_one(values: &mut [f64], left: &[f64], right: &[f64]) {
    for (row, l) in values.chunks_exact_mut(right.len()).zip(left) {
        row.iter_mut().zip(right).for_each(|(value, r)| *value += l * r);
    }
}
