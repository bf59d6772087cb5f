//! Square roots of reflection: R with R R = S, symmetric and positive semidefinite,
//!
//! ```text
//! S = V Λ Vᵀ ,     R = V Λ^½ Vᵀ .
//! ```
//!
//! Eigenvalues err by a multiple of ε ‖S‖ (G. Golub, C. Van Loan, *Matrix Computations*, 4th ed., section
//! 8.3), and so does R R. R itself may err by √(ε ‖S‖) where reflectances vanish, which does no harm: any R
//! with R R = S serves. A Cholesky factor would do but for those reflectances: its pivots then cancel.

use nalgebra::DMatrix;

/// R of the symmetric, positive semidefinite matrix S, row-major; eigenvalues that rounding made negative
/// count as 0.
pub(super) fn square_root(matrix: &[f64]) -> Vec<f64> {
    let n = matrix.len().isqrt();
    let eigen = DMatrix::from_row_slice(n, n, matrix).symmetric_eigen();
    let roots = eigen.eigenvalues.map(|value| value.max(0.0).sqrt());
    let vectors = eigen.eigenvectors;
    let mut square_root = &vectors * DMatrix::from_diagonal(&roots) * vectors.transpose();
    // The entries on both sides of the diagonal differ by rounding.
    square_root.fill_upper_triangle_with_lower_triangle();
    square_root.as_slice().to_vec()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn root_of(matrix: &DMatrix<f64>) -> DMatrix<f64> {
        DMatrix::from_row_slice(matrix.nrows(), matrix.ncols(), &square_root(matrix.as_slice()))
    }

    /// I − 2 v vᵀ/vᵀv, whose columns are orthonormal.
    fn reflection(v: &[f64]) -> DMatrix<f64> {
        let unit = DMatrix::from_column_slice(v.len(), 1, v).normalize();
        DMatrix::identity(v.len(), v.len()) - 2.0 * &unit * unit.transpose()
    }

    proptest! {
        /// R R = S to rounding, also where S is singular.
        #[test]
        fn the_square_of_the_root_is_the_matrix(
            entries in prop::collection::vec(-1.0..1.0f64, 64),
            n in 1usize..9,
            rank in 0usize..9,
        ) {
            let factor = DMatrix::from_fn(n, n, |k, l| if l < rank { entries[8 * k + l] } else { 0.0 });
            let matrix = &factor * factor.transpose();
            let square_root = root_of(&matrix);
            prop_assert_eq!(&square_root, &square_root.transpose());
            prop_assert!((&square_root * &square_root - &matrix).amax() <= 2e-14 * matrix.amax(), "{}", matrix);
        }
    }

    /// Eigenvalues that repeat, vanish or spread over all digits; to the root of rounding where they vanish.
    #[test]
    fn roots_of_known_eigenvalues() {
        let lists: [&[f64]; 6] = [
            &[0.7],
            &[0.3, 0.3, 0.3, 0.3],
            &[0.8, 0.8, 0.0, 0.0, 0.0],
            &[1.0, 1e-4, 1e-8, 1e-12, 1e-16],
            &[1.0, 1.0 - 1e-15, 0.5, 0.5, 0.5, 0.0],
            &[0.0, 0.0, 0.0],
        ];
        for values in lists {
            let n = values.len();
            let v: Vec<f64> = (0..n).map(|k| 1.0 + (k * k) as f64 - 0.3 * k as f64).collect();
            let of =
                |values: Vec<f64>| reflection(&v) * DMatrix::from_diagonal(&values.into()) * reflection(&v);
            let (matrix, right) =
                (of(values.to_vec()), of(values.iter().map(|value| value.sqrt()).collect()));
            let square_root = root_of(&matrix);
            assert!((&square_root * &square_root - &matrix).amax() <= 2e-15, "{values:?}");
            assert!((&square_root - right).amax() <= 3e-8, "{values:?}");
            assert!(square_root.symmetric_eigenvalues().min() > -1e-15, "{values:?}");
        }
    }
}
