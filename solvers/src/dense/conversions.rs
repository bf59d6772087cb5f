//! Matrices of faer and nalgebra as [`Dense`] ones, and views of a [`Dense`] as theirs.

use faer::MatRef;
use nalgebra::{DMatrix, DMatrixView, Dyn};

use super::Dense;
use crate::error::SolveError;
use crate::partition::Partition;

impl TryFrom<DMatrix<f64>> for Dense {
    type Error = SolveError;

    /// Takes the entries without a copy, in blocks of one unknown; symmetric where it is so up to rounding.
    ///
    /// # Errors
    /// [`SolveError::DimensionMismatch`] unless it is square, [`SolveError::NonFinite`].
    fn try_from(matrix: DMatrix<f64>) -> Result<Self, SolveError> {
        let (rows, columns) = matrix.shape();
        Self::square(rows, columns, Vec::from(matrix.data))
    }
}

impl TryFrom<MatRef<'_, f64>> for Dense {
    type Error = SolveError;

    /// Copies the entries, in blocks of one unknown; symmetric where it is so up to rounding.
    ///
    /// # Errors
    /// [`SolveError::DimensionMismatch`] unless it is square, [`SolveError::NonFinite`].
    fn try_from(matrix: MatRef<'_, f64>) -> Result<Self, SolveError> {
        let (rows, columns) = matrix.shape();
        let entries = matrix.col_iter().flat_map(|column| column.iter().copied());
        Self::square(rows, columns, entries.collect())
    }
}

impl<'a> From<&'a Dense> for MatRef<'a, f64> {
    fn from(matrix: &'a Dense) -> Self {
        let dim = matrix.dim();
        MatRef::from_column_major_slice(&matrix.values, dim, dim)
    }
}

impl<'a> From<&'a Dense> for DMatrixView<'a, f64> {
    fn from(matrix: &'a Dense) -> Self {
        let dim = matrix.dim();
        DMatrixView::from_slice_generic(&matrix.values, Dyn(dim), Dyn(dim))
    }
}

impl Dense {
    /// The matrix of `entries` column by column, in blocks of one unknown, if it is square.
    fn square(rows: usize, columns: usize, entries: Vec<f64>) -> Result<Self, SolveError> {
        if rows != columns {
            let (expected, found) = (rows, columns);
            return Err(SolveError::DimensionMismatch { what: "a row of the matrix", expected, found });
        }
        let partition = Partition::points(rows);
        let mut matrix = Self::new(partition, entries, false)?;
        matrix.symmetric = super::is_symmetric(&matrix.values, rows);
        Ok(matrix)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::operator::Operator;

    /// Rows 1 2 and 3 4: unsymmetric, so that a transposed copy shows.
    fn matrices() -> [Dense; 2] {
        let by_nalgebra = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 3.0, 4.0]);
        let by_faer = faer::mat![[1.0, 2.0], [3.0, 4.0]];
        [Dense::try_from(by_nalgebra).unwrap(), Dense::try_from(by_faer.as_ref()).unwrap()]
    }

    #[test]
    fn entries_keep_their_rows_and_columns_there_and_back() {
        for own in matrices() {
            assert_eq!(own.values(), [1.0, 3.0, 2.0, 4.0]);
            assert!(!own.symmetric());
            assert_eq!(MatRef::from(&own)[(0, 1)], 2.0);
            assert_eq!(DMatrixView::from(&own)[(0, 1)], 2.0);
        }
    }

    #[test]
    fn symmetry_is_seen() {
        let by_nalgebra = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 4.0]);
        assert!(Dense::try_from(by_nalgebra).unwrap().symmetric());
        assert!(Dense::try_from(faer::mat![[1.0, 2.0], [2.0, 4.0]].as_ref()).unwrap().symmetric());
    }

    #[test]
    fn rectangles_and_what_is_not_finite_are_refused() {
        let rectangle = Dense::try_from(DMatrix::zeros(2, 3));
        assert!(matches!(rectangle, Err(SolveError::DimensionMismatch { expected: 2, found: 3, .. })));
        let infinite = Dense::try_from(DMatrix::from_element(1, 1, f64::INFINITY));
        assert!(matches!(infinite, Err(SolveError::NonFinite { .. })));
    }
}
