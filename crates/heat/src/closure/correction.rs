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
use radiosity_work::ranks::Ranks;

use super::pairs::Pairs;

/// Most corrections one after another, each of what rounding left of the one before, so that they gain little
/// soon.
const TURNS: usize = 4;
/// Largest deficit that is left alone: some five roundings.
const SETTLED: f64 = 1e-15;

/// Residual over right side at which conjugate gradients end: what is left is taken up by the next turn.
const SOLVED: f64 = 1e-12;

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
pub(super) fn corrected(elements: &Elements, blocks: &Blocks, pairs: &Pairs, rows: &[bool]) -> Blocks {
    let blocks = &*blocks.gathered();
    let integrated = blocks.apply(&elements.constant());
    let mut now = copied(elements, blocks, |_, _, values| values.to_vec());
    for _ in 0..TURNS {
        let deficit = Deficit::of(elements, &now, rows);
        if deficit.largest(elements) <= SETTLED {
            break;
        }
        now = turn(elements, &now, pairs, &deficit);
    }
    now.integrated = Some(integrated);
    now
}

/// The blocks after one correction.
fn turn(elements: &Elements, blocks: &Blocks, pairs: &Pairs, Deficit(deficit): &Deficit) -> Blocks {
    let (list, starts) = (elements.list(), elements.starts());
    let weights = Weights::of(elements, blocks, pairs);
    let right: Vec<f64> =
        list.iter().zip(&starts).map(|(element, start)| element.constant[0] * deficit[*start]).collect();
    let along = weights.solve(&right);
    // The part of λ across c, for the coefficients k > 0 of element i.
    let across = |i: usize, k: usize| match weights.sums[i] {
        0.0 => 0.0,
        sum => deficit[starts[i] + k] * list[i].area / sum,
    };
    copied(elements, blocks, |i, j, values| {
        let mut values = values.to_vec();
        if !pairs.is_exact(i, j) {
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
        }
        values
    })
}

/// Blocks with other values, held by every rank, their counts and errors kept.
fn copied(elements: &Elements, blocks: &Blocks, values: impl Fn(usize, usize, &[f64]) -> Vec<f64>) -> Blocks {
    let mut copy = Blocks::empty(elements.starts(), true, Ranks::alone());
    for PlacedBlock { row, column, values: own } in blocks.iter() {
        copy.push(row, column, &values(row, column, &own));
    }
    let open = (0..elements.list().len()).filter(|element| !blocks.is_complete(*element));
    open.for_each(|element| copy.leave_open(element));
    copy.statistics = blocks.statistics.clone();
    copy
}

/// The matrix Σ_j W_ij (x_i + x_j), by rows; rows without a pair that may be corrected are those of the unit
/// matrix.
struct Weights {
    partition: Partition,
    diagonal: Vec<f64>,
    /// For each row i its (j, W_ij), j ≠ i.
    rows: Vec<Vec<(usize, f64)>>,
    /// Σ_j W_ij of each row i.
    sums: Vec<f64>,
}

impl Weights {
    fn of(elements: &Elements, blocks: &Blocks, pairs: &Pairs) -> Self {
        let list = elements.list();
        let mut rows = vec![Vec::new(); list.len()];
        let (mut sums, mut diagonal) = (vec![0.0; list.len()], vec![0.0; list.len()]);
        let open = blocks.iter().filter(|block| !pairs.is_exact(block.row, block.column));
        for PlacedBlock { row: i, column: j, values } in open {
            let weight = list[i].area * values[0] * values[0] * list[j].area;
            for (own, other) in [(i, j), (j, i)] {
                diagonal[own] += weight;
                if i != j {
                    sums[own] += weight;
                    rows[own].push((other, weight));
                }
            }
            if i == j {
                sums[i] += weight;
            }
        }
        diagonal.iter_mut().filter(|own| **own == 0.0).for_each(|own| *own = 1.0);
        Self { partition: Partition::points(list.len()), diagonal, rows, sums }
    }

    /// The solution for this right side, as near as it comes.
    fn solve(&self, right: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; right.len()];
        let solver = Method::CG.solver;
        let settings = Settings::default().with_tolerance(SOLVED);
        // Where it does not converge, the next turn goes on from its best x.
        let _ = solver.solve(self, right, &mut x, &settings, &mut |_| check_interrupt());
        x
    }
}

impl Operator for Weights {
    fn partition(&self) -> &Partition {
        &self.partition
    }

    fn gather(&self, row: usize, x: &[f64], y: &mut [f64]) {
        y[0] = self.diagonal[row] * x[row]
            + self.rows[row].iter().map(|(other, weight)| weight * x[*other]).sum::<f64>();
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        y[column] += self.diagonal[column] * x[0];
        self.rows[column].iter().for_each(|(other, weight)| y[*other] += weight * x[0]);
    }

    fn symmetric(&self) -> bool {
        true
    }
}
