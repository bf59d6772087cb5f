//! A = L Lᵀ for a symmetric positive definite A, by halves.
//!
//!   A₁₁ = L₁₁ L₁₁ᵀ,   L₂₁ = A₂₁ L₁₁⁻ᵀ,   A₂₂ − L₂₁ L₂₁ᵀ = L₂₂ L₂₂ᵀ,
//!
//! from the lower triangle of A alone, in n³/6 multiplications. Exists exactly if A is positive definite.
//! Reference: N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., SIAM 2002, ch. 10.

use ndarray::{ArrayView2, ArrayViewMut2, Axis, ShapeBuilder};

use crate::factors::Factors;
use crate::panel::{Labour, NARROW, column, for_chunks, subtract_product, two_columns};
use crate::vector::{add_scaled, dot};

/// L on and below the diagonal; what stands above is of no meaning.
pub(crate) struct CholeskyFactor {
    /// Entry (i, j) at `matrix[j·dim + i]`.
    matrix: Vec<f64>,
    dim: usize,
}

impl CholeskyFactor {
    /// Factors a matrix held column by column, of which the lower triangle is read; none unless it is positive
    /// definite, or if that is cancelled.
    pub(crate) fn new(mut matrix: Vec<f64>, dim: usize, labour: Labour<'_>) -> Option<Self> {
        let view = ArrayViewMut2::from_shape((dim, dim).f(), &mut matrix).expect("dim² entries");
        factor(view, labour)?;
        Some(Self { matrix, dim })
    }

    /// Column `j` of L from its diagonal entry on.
    fn column(&self, j: usize) -> &[f64] {
        &self.matrix[j * self.dim..][j..self.dim]
    }
}

impl Factors for CholeskyFactor {
    fn solve(&self, x: &mut [f64]) {
        for j in 0..self.dim {
            let (known, rest) = x.split_at_mut(j + 1);
            let column = self.column(j);
            known[j] /= column[0];
            add_scaled(-known[j], &column[1..], rest);
        }
        for j in (0..self.dim).rev() {
            let column = self.column(j);
            x[j] = (x[j] - dot(&column[1..], &x[j + 1..])) / column[0];
        }
    }

    fn solve_transposed(&self, x: &mut [f64]) {
        self.solve(x);
    }
}

/// Factors a square matrix in place; none where a pivot is not positive.
fn factor(mut matrix: ArrayViewMut2<'_, f64>, labour: Labour<'_>) -> Option<()> {
    if labour.is_cancelled() {
        return None;
    }
    if matrix.ncols() <= NARROW {
        return factor_narrow(&mut matrix);
    }
    let half = matrix.ncols() / 2;
    let (left, right) = matrix.split_at(Axis(1), half);
    let (mut diagonal, mut below) = left.split_at(Axis(0), half);
    let mut rest = right.split_at(Axis(0), half).1;
    factor(diagonal.view_mut(), labour)?;
    divide(below.view_mut(), diagonal.view(), labour);
    subtract_square(below.view(), rest.view_mut(), labour);
    factor(rest, labour)
}

/// The same column by column.
fn factor_narrow(matrix: &mut ArrayViewMut2<'_, f64>) -> Option<()> {
    for k in 0..matrix.ncols() {
        let pivot = column(matrix, k)[k];
        // Not a number is refused as well.
        if pivot.is_nan() || pivot <= 0.0 {
            return None;
        }
        let root = pivot.sqrt();
        column(matrix, k)[k..].iter_mut().for_each(|entry| *entry /= root);
        for j in k + 1..matrix.ncols() {
            let (done, rest) = two_columns(matrix, k, j);
            add_scaled(-done[j], &done[j..], &mut rest[j..]);
        }
    }
    Some(())
}

/// B ← B L⁻ᵀ, unless it is cancelled.
fn divide(mut b: ArrayViewMut2<'_, f64>, lower: ArrayView2<'_, f64>, labour: Labour<'_>) {
    if labour.is_cancelled() {
        return;
    }
    let dim = lower.ncols();
    if dim > NARROW {
        let half = dim / 2;
        let (mut left, mut right) = b.split_at(Axis(1), half);
        let (first, second) = lower.split_at(Axis(1), half);
        let (diagonal, below) = first.split_at(Axis(0), half);
        divide(left.view_mut(), diagonal, labour);
        subtract_product(&left.view(), &below.t(), &mut right);
        return divide(right, second.split_at(Axis(0), half).1, labour);
    }
    for k in 0..dim {
        let root = lower[(k, k)];
        column(&mut b, k).iter_mut().for_each(|entry| *entry /= root);
        for j in k + 1..dim {
            let (done, rest) = two_columns(&mut b, k, j);
            add_scaled(-lower[(j, k)], done, rest);
        }
    }
}

/// C ← C − B Bᵀ on and below the diagonal.
fn subtract_square(b: ArrayView2<'_, f64>, c: ArrayViewMut2<'_, f64>, labour: Labour<'_>) {
    let multiplications = b.len() * c.ncols() / 2;
    for_chunks(c, multiplications, labour, |first, c| {
        let below = b.split_at(Axis(0), first).1;
        let across = below.split_at(Axis(0), c.ncols()).0;
        subtract_product(&below, &across.t(), &mut c.split_at(Axis(0), first).1);
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panel::{CHUNK, random, worst_backward_error};

    /// B Bᵀ + I for a random B, column by column.
    fn positive(dim: usize) -> Vec<f64> {
        let b = random(dim * dim, 11);
        let row = |i: usize| (0..dim).map(move |k| i + k * dim);
        let entry = |i: usize, j: usize| row(i).zip(row(j)).map(|(i, j)| b[i] * b[j]).sum::<f64>();
        let identity = |i, j| if i == j { 1.0 } else { 0.0 };
        (0..dim * dim).map(|k| entry(k % dim, k / dim) + identity(k % dim, k / dim)).collect()
    }

    #[test]
    fn factors_solve_without_refinement() {
        for dim in [0, 1, 2, NARROW, NARROW + 1, 77, CHUNK + 1, 2 * CHUNK + 45] {
            let matrix = positive(dim);
            let factor = CholeskyFactor::new(matrix.clone(), dim, Labour::ALONE).expect("positive definite");
            assert!(worst_backward_error(&matrix, dim, |x| factor.solve(x)) < 1e-13, "{dim}");
        }
    }

    #[test]
    fn only_the_lower_triangle_is_read() {
        let dim = 90;
        let matrix = positive(dim);
        let mut spoilt = matrix.clone();
        (0..dim).for_each(|j| spoilt[j * dim..][..j].fill(f64::NAN));
        let [factor, other] =
            [matrix, spoilt].map(|a| CholeskyFactor::new(a, dim, Labour::ALONE).expect("positive definite"));
        assert!((0..dim).all(|j| factor.column(j) == other.column(j)));
    }

    #[test]
    fn an_eigenvalue_below_zero_is_refused_wherever_it_shows() {
        let dim = 60;
        for spoilt in [0, NARROW, 31, dim - 1] {
            let mut matrix = positive(dim);
            matrix[spoilt * dim + spoilt] *= -1.0;
            assert!(CholeskyFactor::new(matrix, dim, Labour::ALONE).is_none(), "{spoilt}");
        }
    }
}
