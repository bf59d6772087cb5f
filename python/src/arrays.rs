//! Arrays of points in, arrays of numbers out.

use numpy::ndarray::{ArrayD, IxDyn};
use numpy::{IntoPyArray, PyArrayDyn, PyReadonlyArray2};
use pyo3::prelude::*;
use radiosity::geom::DVec3;
use radiosity::reading::probe::Probe;

use crate::error::Trouble;

/// Largest coordinate, as in scenes.
const FARTHEST: f64 = 1e30;

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
    let points = array.rows().into_iter().map(|row| DVec3::new(row[0], row[1], row[2]));
    points
        .enumerate()
        .map(|(index, point)| match point.is_finite() && point.abs().max_element() <= FARTHEST {
            true => Ok(point),
            false => Err(Trouble::new(
                format!("{what}[{index}]: not finite, or farther off than 1e30"),
                "give finite numbers in the unit of the scene",
            )),
        })
        .collect()
}

/// Sensors at points (n, 3) along normals (n, 3) of any length, or along one normal (1, 3).
pub(crate) fn probes(
    positions: &PyReadonlyArray2<'_, f64>,
    normals: &PyReadonlyArray2<'_, f64>,
) -> Result<Vec<Probe>, Trouble> {
    let positions = points("points", positions)?;
    let (count, rows) = (positions.len(), normals.as_array().nrows());
    if count == 0 {
        return Err(Trouble::new("points: an array of shape (0, 3)", "give at least one point"));
    }
    let normals = directions(normals)?;
    if rows != count && rows != 1 {
        return Err(Trouble::new(
            format!("normals: an array of shape ({rows}, 3) instead of ({count}, 3), as that of the points"),
            "give a normal for each point, or one for all",
        ));
    }
    let along = positions.into_iter().zip(normals.into_iter().cycle()).enumerate();
    along
        .map(|(index, (position, normal))| {
            Probe::along(position, normal).ok_or_else(|| {
                Trouble::new(
                    format!("normals[{index}]: the normal is zero"),
                    "give the direction that the light is received along, of any length but 0",
                )
            })
        })
        .collect()
}

/// Finite directions of any length.
fn directions(array: &PyReadonlyArray2<'_, f64>) -> Result<Vec<DVec3>, Trouble> {
    let rows = array.as_array();
    if rows.ncols() != 3 {
        return Err(points("normals", array).expect_err("it is no array of points"));
    }
    let rows = rows.rows().into_iter().map(|row| DVec3::new(row[0], row[1], row[2])).enumerate();
    rows.map(|(index, row)| match row.is_finite() {
        true => Ok(row),
        false => Err(Trouble::new(format!("normals[{index}]: not finite"), "give finite numbers")),
    })
    .collect()
}

/// An array of this shape; the numbers are not copied.
pub(crate) fn array<'py>(py: Python<'py>, shape: &[usize], numbers: Vec<f64>) -> Bound<'py, PyArrayDyn<f64>> {
    let array = ArrayD::from_shape_vec(IxDyn(shape), numbers);
    array.expect("there are as many numbers as the shape says").into_pyarray(py)
}
