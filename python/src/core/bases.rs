//! Orthonormal polynomials in two variables, on the square and on the triangle, and the rule of the triangle.

use std::ops::Range;

use pyo3::prelude::*;
use radiosity_core::basis::{total, triangle};

use super::{Input, Output, by_rows, misfit};

/// Writes the functions of an order at (s, t).
type Values = fn(usize, f64, f64, &mut [f64]);

/// Writes the functions of an order and both partial derivatives at (s, t).
type Gradients = fn(usize, f64, f64, &mut [f64], &mut [f64], &mut [f64]);

/// A basis in two variables.
struct Basis {
    values: Values,
    gradients: Gradients,
}

const SQUARE: Basis = Basis { values: total::values, gradients: total::gradients };

const TRIANGLE: Basis = Basis { values: triangle::values, gradients: triangle::gradients };

/// Writes φ_k of total degree ≤ `order` on the square at each (s, t), and rows of ∂φ_k/∂s, then ∂φ_k/∂t.
#[pyfunction]
#[pyo3(signature = (order, points, out, gradients=None))]
pub(super) fn square_basis(
    py: Python<'_>,
    order: usize,
    points: Input<'_>,
    out: Output<'_>,
    gradients: Option<Output<'_>>,
) -> PyResult<()> {
    if order > total::LARGEST {
        return Err(misfit("the order of the square's basis is 63 at the most"));
    }
    write(py, &SQUARE, order, points, out, gradients)
}

/// Writes values and gradients as [`square_basis`] does, with Dubiner's functions on the triangle (−1, −1),
/// (1, −1), (−1, 1).
#[pyfunction]
#[pyo3(signature = (order, points, out, gradients=None))]
pub(super) fn triangle_basis(
    py: Python<'_>,
    order: usize,
    points: Input<'_>,
    out: Output<'_>,
    gradients: Option<Output<'_>>,
) -> PyResult<()> {
    write(py, &TRIANGLE, order, points, out, gradients)
}

/// Writes (s, t, w) of the rule on the triangle that a Legendre rule across and a Jacobi (1, 0) rule along
/// collapse to.
#[pyfunction]
pub(super) fn triangle_rule(
    nodes_across: Input<'_>,
    weights_across: Input<'_>,
    nodes_along: Input<'_>,
    weights_along: Input<'_>,
    mut out: Output<'_>,
) -> PyResult<()> {
    let across = nodes_across.as_slice()?.iter().zip(weights_across.as_slice()?);
    let along = nodes_along.as_slice()?.iter().zip(weights_along.as_slice()?);
    let points =
        along.flat_map(|(&t, &w)| across.clone().map(move |(&a, &v)| triangle::collapse((a, v), (t, w))));
    for (row, point) in out.as_slice_mut()?.chunks_exact_mut(3).zip(points) {
        row.copy_from_slice(&[point.s, point.t, point.weight]);
    }
    Ok(())
}

fn write(
    py: Python<'_>,
    basis: &Basis,
    order: usize,
    points: Input<'_>,
    mut out: Output<'_>,
    mut gradients: Option<Output<'_>>,
) -> PyResult<()> {
    let count = total::count(order);
    let (points, out) = (points.as_slice()?.as_chunks::<2>().0, out.as_slice_mut()?);
    let slopes = gradients.as_mut().map(|slopes| slopes.as_slice_mut()).transpose()?;
    let fits = |length: usize, wide: usize| points.len().checked_mul(count * wide) == Some(length);
    if !fits(out.len(), 1) || slopes.as_ref().is_some_and(|slopes| !fits(slopes.len(), 2)) {
        return Err(misfit("one number per point and function is wanted"));
    }
    let numbers = |some: &Range<usize>, wide: usize| some.start * wide..some.end * wide;
    match slopes {
        None => by_rows(py, points.len(), count, |some| {
            let rows = out[numbers(&some, count)].chunks_exact_mut(count);
            for (&[s, t], row) in points[some].iter().zip(rows) {
                (basis.values)(order, s, t, row);
            }
        }),
        Some(slopes) => by_rows(py, points.len(), 3 * count, |some| {
            let rows = out[numbers(&some, count)].chunks_exact_mut(count);
            let rows = rows.zip(slopes[numbers(&some, 2 * count)].chunks_exact_mut(2 * count));
            for (&[s, t], (row, slopes)) in points[some].iter().zip(rows) {
                let (by_s, by_t) = slopes.split_at_mut(count);
                (basis.gradients)(order, s, t, row, by_s, by_t);
            }
        }),
    }
}
