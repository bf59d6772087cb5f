//! The least symmetric correction of blocks that closes their rows.
//!
//! With the deficits r_i = c_i − Σ_j G_ij c_j the corrections ΔG_ij = ΔG_jiᵀ solve
//!
//! ```text
//! minimise Σ ‖ΔG_ij‖² / w_ij     subject to Σ_j ΔG_ij c_j = r_i ;     ΔG_ij = w_ij (λ_i c_jᵀ + c_i λ_jᵀ) .
//! ```
//!
//! w_ij is the square of G_ij between constants, 0 for exact pairs: large exchanges err by more than small
//! ones (M. E. Larsen, J. R. Howell, *J. Heat Transfer* 108 (1986) 239-242). The part of λ_i along c_i, l_i
//! c_i, solves
//!
//! ```text
//! Σ_j W_ij (l_i + l_j) = r_i · c_i ,     W_ij = A_i w_ij A_j ,
//! ```
//!
//! a positive semidefinite system, by conjugate gradients with its diagonal as preconditioner; the part
//! across c_i is r_i A_i / Σ_j W_ij there.

use radiosity_elements::Elements;
use radiosity_kernel::{Blocks, PlacedBlock};
use radiosity_solvers::method::Method;
use radiosity_solvers::{Operator, Partition, Settings};
use radiosity_work::interruption::check_interrupt;

use super::pairs::Pairs;

/// Most corrections one after another, each of what rounding left of the one before, so that they gain little
/// soon.
const TURNS: usize = 4;
/// Largest deficit that is left alone, over the root of the number of elements: two roundings of as many terms.
const SETTLED: f64 = 4e-16;

/// Residual over right side at which conjugate gradients end, and that over the deficit that is left alone: what is
/// left is taken up by the next turn.
const SOLVED: f64 = 1e-12;
const LEFT: f64 = 0.1;

/// Deficit c − G c of the rows: a number for each coefficient (scene length).
#[derive(Debug)]
pub(super) struct Deficit(Vec<f64>);

impl Deficit {
    /// Deficit of the `rows` that are known, 0 in all others.
    pub(super) fn of(elements: &Elements, blocks: &Blocks, rows: &[bool]) -> Self {
        let ones = elements.constant();
        let mut lacking: Vec<f64> =
            ones.iter().zip(blocks.apply(&ones)).map(|(one, carried)| one - carried).collect();
        for (range, is_known) in elements.starts().windows(2).zip(rows) {
            if !is_known {
                lacking[range[0]..range[1]].fill(0.0);
            }
        }
        Self(lacking)
    }

    /// The largest distance of a row sum from 1.
    pub(super) fn largest(&self, elements: &Elements) -> f64 {
        let list = elements.list().iter().zip(elements.starts());
        list.map(|(element, start)| (element.constant[0] * self.0[start] / element.area).abs())
            .fold(0.0, f64::max)
    }
}

/// The blocks with rows that sum to 1 where these are known; every rank has all of them.
pub(super) fn corrected(elements: &Elements, blocks: Blocks, pairs: &Pairs, rows: &[bool]) -> Blocks {
    let mut blocks = blocks.into_gathered();
    let integrated = blocks.apply(&elements.constant());
    let settled = SETTLED * (elements.list().len() as f64).sqrt();
    for _ in 0..TURNS {
        let deficit = Deficit::of(elements, &blocks, rows);
        let largest = deficit.largest(elements);
        if largest <= settled {
            break;
        }
        correct(elements, &mut blocks, pairs, &deficit, SOLVED.max(LEFT * settled / largest));
    }
    blocks.integrated = Some(integrated);
    blocks
}

/// Corrects blocks once, up to this residual over the deficit.
fn correct(
    elements: &Elements,
    blocks: &mut Blocks,
    pairs: &Pairs,
    Deficit(deficit): &Deficit,
    tolerance: f64,
) {
    let (list, starts) = (elements.list(), elements.starts());
    let right: Vec<f64> =
        list.iter().zip(&starts).map(|(element, start)| element.constant[0] * deficit[*start]).collect();
    let (along, sums) = {
        let weights = Weights::of(elements, blocks, pairs);
        (weights.solve(&right, tolerance), weights.sums)
    };
    // The part of λ across c, for the coefficients k > 0 of element i.
    let across = |i: usize, k: usize| match sums[i] {
        0.0 => 0.0,
        sum => deficit[starts[i] + k] * list[i].area / sum,
    };
    blocks.change(|i, j, values| {
        if pairs.is_exact(i, j) {
            return;
        }
        let [one, other] = [list[i].constant[0], list[j].constant[0]];
        let weight = values[0] * values[0];
        let columns = list[j].constant.len();
        values[0] += weight * one * other * (along[i] + along[j]);
        for (k, value) in values.iter_mut().step_by(columns).enumerate().skip(1) {
            *value += weight * other * across(i, k);
        }
        for (l, value) in values[..columns].iter_mut().enumerate().skip(1) {
            *value += weight * one * across(j, l);
        }
    });
}

/// The matrix Σ_j W_ij (x_i + x_j); rows without a pair that may be corrected are those of the unit matrix.
struct Weights<'a> {
    elements: &'a Elements,
    blocks: &'a Blocks,
    pairs: &'a Pairs,
    partition: Partition,
    diagonal: Vec<f64>,
    /// Σ_j W_ij of each row i.
    sums: Vec<f64>,
}

impl<'a> Weights<'a> {
    fn of(elements: &'a Elements, blocks: &'a Blocks, pairs: &'a Pairs) -> Self {
        let count = elements.list().len();
        let mut weights = Self {
            elements,
            blocks,
            pairs,
            partition: Partition::points(count),
            diagonal: Vec::new(),
            sums: Vec::new(),
        };
        let (mut sums, mut diagonal) = (vec![0.0; count], vec![0.0; count]);
        for (i, j, weight) in weights.all() {
            for own in [i, j] {
                diagonal[own] += weight;
                sums[own] += if i != j { weight } else { 0.5 * weight };
            }
        }
        diagonal.iter_mut().filter(|own| **own == 0.0).for_each(|own| *own = 1.0);
        (weights.sums, weights.diagonal) = (sums, diagonal);
        weights
    }

    /// All (i, j, W_ij) that differ from zero, i ≤ j.
    fn all(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let list = self.elements.list();
        let open = self.blocks.iter().filter(|block| !self.pairs.is_exact(block.row, block.column));
        open.map(|PlacedBlock { row: i, column: j, values }| {
            (i, j, list[i].area * values[0] * values[0] * list[j].area)
        })
    }

    /// The solution for this right side to such a residual, as near as it comes.
    fn solve(&self, right: &[f64], tolerance: f64) -> Vec<f64> {
        let mut x = vec![0.0; right.len()];
        let solver = Method::CG.solver;
        let settings = Settings::default().with_tolerance(tolerance);
        // Where it does not converge, the next turn goes on from its best x.
        let _ = solver.solve(self, right, &mut x, &settings, &mut |_| check_interrupt());
        x
    }
}

impl Operator for Weights<'_> {
    fn partition(&self) -> &Partition {
        &self.partition
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        y.iter_mut().zip(x).zip(&self.diagonal).for_each(|((y, x), own)| *y = own * x);
        for (i, j, weight) in self.all().filter(|(i, j, _)| i != j) {
            y[i] += weight * x[j];
            y[j] += weight * x[i];
        }
    }

    fn diagonal(&self, block: usize, out: &mut [f64]) {
        out[0] = self.diagonal[block];
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        y[column] += self.diagonal[column] * x[0];
        for (i, j, weight) in self.all().filter(|(i, j, _)| i != j) {
            if i == column {
                y[j] += weight * x[0];
            } else if j == column {
                y[i] += weight * x[0];
            }
        }
    }

    fn symmetric(&self) -> bool {
        true
    }
}
