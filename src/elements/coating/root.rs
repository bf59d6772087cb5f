//! Square roots of reflection: R with R R = S, symmetric and positive semidefinite,
//!
//! ```text
//! S = V Λ Vᵀ ,     R = V Λ^½ Vᵀ ,
//! ```
//!
//! by Jacobi's rotations, which find small eigenvalues of such matrices well (G. Golub, C. Van Loan, *Matrix Computations*,
//! 4th ed., section 8.5). A Cholesky factor would do but for reflectances that vanish somewhere: its pivots then cancel.

/// Most sweeps over all pairs; some ten are needed. Chosen.
const MOST_SWEEPS: usize = 40;

/// R of the symmetric, positive semidefinite matrix S, row-major; eigenvalues that rounding made negative count as 0.
pub(super) fn square_root(matrix: &[f64]) -> Vec<f64> {
    let n = matrix.len().isqrt();
    let (values, vectors) = eigen(matrix, n);
    let roots: Vec<f64> = values.iter().map(|value| value.max(0.0).sqrt()).collect();
    let mut root = vec![0.0; n * n];
    let line = |k: usize| &vectors[k * n..][..n];
    for k in 0..n {
        for l in 0..=k {
            let value = line(k).iter().zip(line(l)).zip(&roots).map(|((x, y), root)| x * y * root).sum();
            root[k * n + l] = value;
            root[l * n + k] = value;
        }
    }
    root
}

/// Eigenvalues, and eigenvectors as the columns of a row-major matrix.
fn eigen(matrix: &[f64], n: usize) -> (Vec<f64>, Vec<f64>) {
    let mut a = matrix.to_vec();
    let mut vectors = vec![0.0; n * n];
    vectors.iter_mut().step_by(n + 1).for_each(|diagonal| *diagonal = 1.0);
    let size = a.iter().map(|x| x * x).sum::<f64>();
    for _ in 0..MOST_SWEEPS {
        let off: f64 =
            (0..n).flat_map(|k| (0..k).map(move |l| k * n + l)).map(|place| a[place].powi(2)).sum();
        if off <= f64::EPSILON.powi(2) * size {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                rotate(&mut a, &mut vectors, n, [p, q]);
            }
        }
    }
    ((0..n).map(|k| a[k * n + k]).collect(), vectors)
}

/// Makes the entry (p, q) of A vanish by a rotation of two axes.
fn rotate(a: &mut [f64], vectors: &mut [f64], n: usize, [p, q]: [usize; 2]) {
    let off = a[p * n + q];
    if off == 0.0 {
        return;
    }
    let ratio = (a[q * n + q] - a[p * n + p]) / (2.0 * off);
    let t = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
    let c = 1.0 / t.hypot(1.0);
    let s = t * c;
    let turn = |x: f64, y: f64| (c * x - s * y, s * x + c * y);
    for k in 0..n {
        (a[k * n + p], a[k * n + q]) = turn(a[k * n + p], a[k * n + q]);
        (vectors[k * n + p], vectors[k * n + q]) = turn(vectors[k * n + p], vectors[k * n + q]);
    }
    for k in 0..n {
        (a[p * n + k], a[q * n + k]) = turn(a[p * n + k], a[q * n + k]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn product(x: &[f64], y: &[f64], n: usize) -> Vec<f64> {
        (0..n * n).map(|k| (0..n).map(|l| x[k / n * n + l] * y[l * n + k % n]).sum()).collect()
    }

    proptest! {
        /// R R = S to rounding, also where S is singular.
        #[test]
        fn the_square_of_the_root_is_the_matrix(
            entries in prop::collection::vec(-1.0..1.0f64, 25),
            rank in 1usize..6,
        ) {
            let mut factor = entries;
            factor.iter_mut().enumerate().filter(|(k, _)| k % 5 >= rank).for_each(|(_, x)| *x = 0.0);
            let transpose: Vec<f64> = (0..25).map(|k| factor[k % 5 * 5 + k / 5]).collect();
            let matrix = product(&factor, &transpose, 5);
            let root = square_root(&matrix);
            let back = product(&root, &root, 5);
            let size = matrix.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            for (x, y) in matrix.iter().zip(&back) {
                prop_assert!((x - y).abs() <= 1e-14 * size.max(1e-300), "{x} {y}");
            }
        }
    }
}
