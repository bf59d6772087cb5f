//! Moments of the kernel between two elements, in their raw polynomials:
//!
//! ```text
//! M_kl += Σ_ab  w_a A_a w_b A_b κ(x_a, y_b) V(x_a, y_b) L_k(x_a) L_l(y_b) ,      G = T_i M T_jᵀ .
//! ```
//!
//! Each pair of patches is summed in products along its charts (`crate::moments::chart`), so that the sums
//! factorise, and then changed to the elements' functions once.

pub mod node_pair;
pub mod integrand;
pub(crate) mod legendre_values;
pub(crate) mod change;
pub(crate) mod chart;
pub mod tensor;

use std::borrow::Cow;

use radiosity_core::dot;
use radiosity_elements::basis::AreaBasis;
use radiosity_elements::columns::transposed;
use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::{Line, UnitRule};
use radiosity_work::interruption::check_interrupt;

use crate::moments::change::Change;
use crate::moments::chart::Chart;
use crate::moments::integrand::{Sees, visible_kernel};
use crate::moments::tensor::{Grid, Terms};

/// Role of an element in a pair: receiver or emitter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Index i of a block, its rows.
    Receiver,
    /// Index j of a block, its columns.
    Emitter,
}

/// Moments of one pair of elements, while they are summed.
#[derive(Debug)]
pub struct Moments<'a> {
    receiver: &'a AreaBasis,
    emitter: &'a AreaBasis,
    /// M, row-major, receiver functions by emitter functions.
    values: Vec<f64>,
    /// Terms of the rules.
    pub samples: u64,
    /// Kernel evaluations: fewer than the terms where kernel values repeat.
    pub distinct: u64,
    /// Segments tested for visibility.
    pub rays: u64,
}

/// Moments of one pair of patches, in the products of their charts.
#[derive(Debug)]
pub(crate) struct PatchMoments<'p> {
    pub patches: [&'p Patch; 2],
    /// The products on either patch.
    pub charts: [Chart; 2],
    /// Row-major, receiver's products by emitter's.
    pub values: Vec<f64>,
    /// Kernel evaluations.
    pub samples: u64,
    /// Segments tested for visibility.
    pub rays: u64,
}

impl PatchMoments<'_> {
    /// Adds `weight` times the tensor rule with nodes and weights along s and t of the receiver, then u and v
    /// of the emitter, all in [0, 1].
    pub(crate) fn product(&mut self, [s, t, u, v]: [Line; 4], weight: f64, sees: Option<Sees>) {
        check_interrupt();
        let receiver = Grid::new(self.patches[0], &self.charts[0], s, t);
        let emitter = Grid::new(self.patches[1], &self.charts[1], u, v);
        tensor::add(&mut self.values, weight, [&receiver, &emitter], sees, &mut self.rays);
        self.samples += (receiver.len() * emitter.len()) as u64;
    }
}

impl<'a> Moments<'a> {
    /// Sums of the functions of `receiver` by those of `emitter`, all 0 yet.
    pub fn new(receiver: &'a AreaBasis, emitter: &'a AreaBasis) -> Self {
        let (rows, columns) = (receiver.len(), emitter.len());
        Self { receiver, emitter, values: vec![0.0; rows * columns], samples: 0, distinct: 0, rays: 0 }
    }

    /// Zero moments of two patches of the elements.
    pub(crate) fn patches<'p>(&self, p: &'p Patch, q: &'p Patch) -> PatchMoments<'p> {
        let charts = [Chart::of(p, self.receiver), Chart::of(q, self.emitter)];
        let values = vec![0.0; charts[0].len() * charts[1].len()];
        PatchMoments { patches: [p, q], charts, values, samples: 0, rays: 0 }
    }

    /// Adds the moments of two patches.
    pub(crate) fn add(&mut self, pair: PatchMoments) {
        self.samples += pair.samples;
        self.distinct += pair.samples;
        self.rays += pair.rays;
        let [receiver, emitter] = pair.charts.map(|chart| chart.change);
        self.changed(&pair.values, receiver.as_ref(), emitter.as_ref());
    }

    /// Adds the tensor Gauss rule with `points` [along, across] of the receiver, then of the emitter.
    pub fn tensor(&mut self, p: &Patch, q: &Patch, points: [usize; 4], sees: Option<Sees>) {
        let mut pair = self.patches(p, q);
        pair.product(points.map(|n| UnitRule::of(n).line()), 1.0, sees);
        self.add(pair);
    }

    /// Adds one pair of points, `weight` being that of the parameters of both charts.
    pub(crate) fn scattered(&mut self, x: &Node, y: &Node, weight: f64, sees: Option<Sees>) {
        self.samples += 1;
        self.distinct += 1;
        let value = visible_kernel(x, y, sees, &mut self.rays) * weight * x.area * y.area;
        if value != 0.0 {
            let mut column = vec![0.0; self.emitter.len()];
            self.emitter.raw(self.emitter.frame().coordinates(y), &mut column);
            self.outer(Side::Receiver, x, value, &column, 0);
        }
    }

    /// Adds moments in the raw polynomials that took `samples` kernel evaluations.
    pub fn add_raw(&mut self, moments: &[f64], samples: u64) {
        self.values.iter_mut().zip(moments).for_each(|(value, moment)| *value += moment);
        self.samples += samples;
        self.distinct += samples;
    }

    /// Adds the moments of each term of `kernel` by the tensor Gauss rule with `points` [along, across] of
    /// the receiver, then of the emitter, to one of `sums`.
    pub(crate) fn add_terms(
        sums: &mut [Self],
        [p, q]: [&Patch; 2],
        points: [usize; 4],
        kernel: &mut impl Terms,
    ) {
        let Some([receiver, emitter]) = sums.first().map(Self::bases) else { return };
        let charts = [Chart::of(p, receiver), Chart::of(q, emitter)];
        let [s, t, u, v] = points.map(|n| UnitRule::of(n).line());
        let grids = [Grid::new(p, &charts[0], s, t), Grid::new(q, &charts[1], u, v)];
        let samples = (grids[0].len() * grids[1].len()) as u64;
        for (sum, values) in sums.iter_mut().zip(tensor::of_terms([&grids[0], &grids[1]], kernel)) {
            sum.changed(&values, charts[0].change.as_ref(), charts[1].change.as_ref());
            sum.samples += samples;
            sum.distinct += samples;
        }
    }

    /// The moments so far, in the raw polynomials.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Adds another sum of the same elements if `kept`, and its cost in any case.
    pub fn merge(&mut self, other: &Self, kept: bool) {
        if kept {
            self.values.iter_mut().zip(&other.values).for_each(|(value, moment)| *value += moment);
        }
        self.samples += other.samples;
        self.distinct += other.distinct;
        self.rays += other.rays;
    }

    /// Multiplies all sums by `factor`.
    pub fn scale(&mut self, factor: f64) {
        self.values.iter_mut().for_each(|value| *value *= factor);
    }

    /// Bases of receiver and emitter.
    pub fn bases(&self) -> [&'a AreaBasis; 2] {
        [self.receiver, self.emitter]
    }

    /// Adds one point x of the element `side`. `inner` = ∫ κ(x, y) L(y) dA_y over a part of the other
    /// element, which took `samples` evaluations.
    pub fn outer(&mut self, side: Side, x: &Node, weight: f64, inner: &[f64], samples: u64) {
        self.samples += samples;
        self.distinct += samples;
        let basis = self.bases()[side as usize];
        let mut own = vec![0.0; basis.len()];
        basis.raw(basis.frame().coordinates(x), &mut own);
        let (left, right) = match side {
            Side::Receiver => (&own[..], inner),
            Side::Emitter => (inner, &own[..]),
        };
        for (row, l) in self.values.chunks_exact_mut(right.len()).zip(left) {
            row.iter_mut().zip(right).for_each(|(value, r)| *value += weight * l * r);
        }
    }

    /// Adds moments in the own polynomials of two parallelograms, receiver's index first.
    pub(crate) fn own(&mut self, p: &Patch, q: &Patch, own: &[f64]) {
        self.changed(own, Some(&Change::new(p, self.receiver)), Some(&Change::new(q, self.emitter)));
    }

    /// Adds C_i X C_jᵀ, where a missing change is the unit matrix.
    fn changed(&mut self, values: &[f64], receiver: Option<&Change>, emitter: Option<&Change>) {
        let (rows, columns) = (self.receiver.len(), self.emitter.len());
        let inner = values.len() / receiver.map_or(rows, Change::own);
        let mut half = Cow::Borrowed(values);
        if let Some(change) = receiver {
            half = Cow::Owned(change.rows(&half, inner));
        }
        if let Some(change) = emitter {
            half = Cow::Owned(transposed(&change.rows(&transposed(&half, inner), rows), rows));
        }
        debug_assert_eq!(half.len(), rows * columns);
        self.values.iter_mut().zip(half.iter()).for_each(|(value, own)| *value += own);
    }

    /// G = T_i M T_jᵀ, row-major.
    pub fn into_block(self) -> Vec<f64> {
        let (rows, columns) = (self.receiver.len(), self.emitter.len());
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
                *g = dot(transform, &row[..=l]);
            }
        }
        block
    }
}
