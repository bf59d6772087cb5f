//! Arrays of points in, arrays of numbers out.

use numpy::ndarray::{Array, ArrayD, IxDyn};
use numpy::{IntoPyArray, PyArrayDyn, PyReadonlyArray2};
use pyo3::prelude::*;
use radiosity::geom::DVec3;

use crate::error::Trouble;

/// The points of an array of shape (n, 3), called `what` in messages.
pub(crate) fn points(what: &str, array: &PyReadonlyArray2<'_, f64>) -> Result<Vec<DVec3>, Trouble> {
    let array = array.as_array();
    if array.ncols() != 3 {
        let [rows, columns] = [array.nrows(), array.ncols()];
        return Err(Trouble::new(
            format!("{what}: an array of shape ({rows}, {columns}) instead of (n, 3)"),
            "give a row x, y, z for each of them",
        ));
    }
    Ok(array.rows().into_iter().map(|row| DVec3::new(row[0], row[1], row[2])).collect())
}

/// An array of this shape; the numbers are not copied.
pub(crate) fn array<'py>(py: Python<'py>, shape: &[usize], numbers: Vec<f64>) -> Bound<'py, PyArrayDyn<f64>> {
    let array: ArrayD<f64> =
        Array::from_shape_vec(IxDyn(shape), numbers).expect("there are as many numbers as the shape says");
    array.into_pyarray(py)
}
