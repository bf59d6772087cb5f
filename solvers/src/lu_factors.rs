//! P A = L U: Gaussian elimination with row interchanges, by halves.
//!
//! With the columns in two halves, [A₁ A₂],
//!
//!   P₁ A₁ = [L₁₁; L₂₁] U₁₁,   U₁₂ = L₁₁⁻¹ (P₁ A₂)₁,   P₂ ((P₁ A₂)₂ − L₂₁ U₁₂) = L₂₂ U₂₂,
//!
//! and the halves likewise, down to narrow panels. The pivot of a column is its largest entry at or below the
//! diagonal, the first of several. n³/3 multiplications. Reference: G. Golub, C. Van Loan, *Matrix
//! Computations*, 4th ed., Johns Hopkins 2013, §3.4; S. Toledo, *SIAM J. Matrix Anal. Appl.* 18 (1997)
//! 1065-1081.

use ndarray::{ArrayView2, ArrayViewMut2, Axis, ShapeBuilder};

use crate::factors::Factors;
use crate::panel::{Labour, NARROW, column, for_chunks, subtract_product, two_columns};
use crate::vector::{add_scaled, dot};

/// L below the diagonal, with ones on it, and U above, of a matrix whose rows were interchanged.
pub(crate) struct LuFactors {
    /// Entry (i, j) at `matrix[j·dim + i]`.
    matrix: Vec<f64>,
    /// Row k was interchanged with row `swaps[k]` ≥ k, in ascending order of k.
    swaps: Vec<usize>,
}

impl LuFactors {
    /// Factors a matrix held column by column; none if a pivot is exactly 0.
    pub(crate) fn new(mut matrix: Vec<f64>, dim: usize, labour: Labour<'_>) -> Option<Self> {
        let mut swaps = vec![0; dim];
        let view = ArrayViewMut2::from_shape((dim, dim).f(), &mut matrix).expect("dim² entries");
        factor(view, &mut swaps, labour);
        let regular = (0..dim).all(|k| matrix[k * dim + k] != 0.0);
        regular.then_some(Self { matrix, swaps })
    }

    /// Column `j` of both factors.
    fn column(&self, j: usize) -> &[f64] {
        let dim = self.swaps.len();
        &self.matrix[j * dim..][..dim]
    }
}

impl Factors for LuFactors {
    fn solve(&self, x: &mut [f64]) {
        let dim = x.len();
        for (k, row) in self.swaps.iter().enumerate() {
            x.swap(k, *row);
        }
        for j in 0..dim {
            let (known, rest) = x.split_at_mut(j + 1);
            add_scaled(-known[j], &self.column(j)[j + 1..], rest);
        }
        for j in (0..dim).rev() {
            let (rest, known) = x.split_at_mut(j);
            known[0] /= self.column(j)[j];
            add_scaled(-known[0], &self.column(j)[..j], rest);
        }
    }

    fn solve_transposed(&self, x: &mut [f64]) {
        // Aᵀ = Uᵀ Lᵀ P.
        let dim = x.len();
        for j in 0..dim {
            x[j] = (x[j] - dot(&self.column(j)[..j], &x[..j])) / self.column(j)[j];
        }
        for j in (0..dim).rev() {
            x[j] -= dot(&self.column(j)[j + 1..], &x[j + 1..]);
        }
        for (k, row) in self.swaps.iter().enumerate().rev() {
            x.swap(k, *row);
        }
    }
}

/// Factors a panel with at least as many rows as columns, in place, unless it is cancelled.
fn factor(mut panel: ArrayViewMut2<'_, f64>, swaps: &mut [usize], labour: Labour<'_>) {
    if labour.is_cancelled() {
        return;
    }
    if panel.ncols() <= NARROW {
        return factor_narrow(&mut panel, swaps);
    }
    let half = panel.ncols() / 2;
    let (mut left, mut right) = panel.split_at(Axis(1), half);
    factor(left.view_mut(), &mut swaps[..half], labour);
    update(left.view(), right.view_mut(), &swaps[..half], labour);
    factor(right.split_at(Axis(0), half).1, &mut swaps[half..], labour);
    interchange(&mut left.split_at(Axis(0), half).1, &swaps[half..]);
    swaps[half..].iter_mut().for_each(|row| *row += half);
}

/// The same column by column.
fn factor_narrow(panel: &mut ArrayViewMut2<'_, f64>, swaps: &mut [usize]) {
    for k in 0..panel.ncols() {
        let pivot = largest(&column(panel, k)[k..]) + k;
        swaps[k] = pivot;
        for j in 0..panel.ncols() {
            column(panel, j).swap(k, pivot);
        }
        let multipliers = &mut column(panel, k)[k..];
        let inverse = multipliers[0].recip();
        if multipliers[0] != 0.0 {
            let exact = inverse.is_finite();
            let pivot = multipliers[0];
            multipliers[1..].iter_mut().for_each(|m| *m = if exact { *m * inverse } else { *m / pivot });
        }
        for j in k + 1..panel.ncols() {
            let (multipliers, rest) = two_columns(panel, k, j);
            add_scaled(-rest[k], &multipliers[k + 1..], &mut rest[k + 1..]);
        }
    }
}

/// Index of the largest magnitude, the first of several.
fn largest(entries: &[f64]) -> usize {
    let mut best = 0;
    for (i, entry) in entries.iter().enumerate() {
        if entry.abs() > entries[best].abs() {
            best = i;
        }
    }
    best
}

/// What the factored columns `left` do to those on their right: interchanges, U₁₂ and the remainder.
fn update(left: ArrayView2<'_, f64>, right: ArrayViewMut2<'_, f64>, swaps: &[usize], labour: Labour<'_>) {
    let half = left.ncols();
    let (diagonal, below) = left.split_at(Axis(0), half);
    let multiplications = left.len() * right.ncols();
    for_chunks(right, multiplications, labour, |_, mut right| {
        interchange(&mut right, swaps);
        let (mut top, mut bottom) = right.split_at(Axis(0), half);
        substitute(diagonal, top.view_mut());
        subtract_product(&below, &top.view(), &mut bottom);
    });
}

/// Interchanges rows as `swaps` tells.
fn interchange(panel: &mut ArrayViewMut2<'_, f64>, swaps: &[usize]) {
    for j in 0..panel.ncols() {
        let column = column(panel, j);
        swaps.iter().enumerate().for_each(|(k, row)| column.swap(k, *row));
    }
}

/// B ← L⁻¹ B for a lower triangle with ones on its diagonal.
fn substitute(lower: ArrayView2<'_, f64>, mut b: ArrayViewMut2<'_, f64>) {
    let dim = lower.ncols();
    if dim > NARROW {
        let half = dim / 2;
        let (first, second) = lower.split_at(Axis(0), half);
        let (mut top, mut bottom) = b.split_at(Axis(0), half);
        substitute(first.split_at(Axis(1), half).0, top.view_mut());
        let (across, diagonal) = second.split_at(Axis(1), half);
        subtract_product(&across, &top.view(), &mut bottom);
        return substitute(diagonal, bottom);
    }
    for column_of_b in 0..b.ncols() {
        let x = column(&mut b, column_of_b);
        for j in 0..dim {
            let (known, rest) = x.split_at_mut(j + 1);
            let multipliers = lower.column(j);
            let multipliers = multipliers.as_slice().expect("columns are contiguous");
            add_scaled(-known[j], &multipliers[j + 1..], rest);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panel::{CHUNK, random, worst_backward_error};

    /// Below, at and above the width of narrow panels and of chunks.
    const SIZES: [usize; 8] = [0, 1, 2, NARROW, NARROW + 1, 77, CHUNK + 1, 2 * CHUNK + 45];

    #[test]
    fn factors_solve_without_refinement() {
        for dim in SIZES {
            let mut matrix = random(dim * dim, 3);
            // Zeros on the diagonal: rows must be interchanged.
            (0..dim).filter(|_| dim > 1).for_each(|k| matrix[k * dim + k] = 0.0);
            let transposed: Vec<f64> = (0..dim * dim).map(|k| matrix[k % dim * dim + k / dim]).collect();
            let factors =
                LuFactors::new(matrix.clone(), dim, Labour::ALONE).expect("random matrices are regular");
            assert!(worst_backward_error(&matrix, dim, |x| factors.solve(x)) < 1e-13, "{dim}");
            assert!(worst_backward_error(&transposed, dim, |x| factors.solve_transposed(x)) < 1e-13, "{dim}");
        }
    }

    #[test]
    fn multipliers_never_exceed_one() {
        let dim = 100;
        let factors =
            LuFactors::new(random(dim * dim, 5), dim, Labour::ALONE).expect("random matrices are regular");
        assert!((0..dim).all(|j| factors.column(j)[j + 1..].iter().all(|m| m.abs() <= 1.0)));
    }

    #[test]
    fn a_column_of_zeros_is_singular() {
        let dim = 50;
        let mut matrix = random(dim * dim, 7);
        matrix[31 * dim..][..dim].fill(0.0);
        assert!(LuFactors::new(matrix, dim, Labour::ALONE).is_none());
    }
}
