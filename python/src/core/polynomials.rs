//! Values of orthonormal and classical polynomials, and sums of them.

use std::ops::Range;

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use radiosity_core::jacobi::Entry;
use radiosity_core::legendre;

use super::family::Family;
use super::{Input, Output, by_rows, misfit, weight};

/// `out[i · m + k]` = `p_k(x[i])` for k < m, m = `count` > 0, orthonormal for the weight (1 − x)^α (1 + x)^β,
/// and `slopes[i · m + k]` = `p_k′(x[i])` where slopes are given.
#[pyfunction]
#[pyo3(signature = (alpha, beta, count, x, out, slopes=None))]
pub(super) fn orthonormal(
    py: Python<'_>,
    alpha: f64,
    beta: f64,
    count: usize,
    x: Input<'_>,
    mut out: Output<'_>,
    mut slopes: Option<Output<'_>>,
) -> PyResult<()> {
    let weight = weight(alpha, beta)?;
    let (x, out) = (x.as_slice()?, out.as_slice_mut()?);
    let slopes = slopes.as_mut().map(|slopes| slopes.as_slice_mut()).transpose()?;
    check(x.len(), count, out.len())?;
    check(x.len(), count, slopes.as_ref().map_or(out.len(), |slopes| slopes.len()))?;
    let mut entries = vec![Entry::EMPTY; count];
    let family = Family::new(weight, &mut entries);
    let numbers = |some: &Range<usize>| some.start * count..some.end * count;
    match slopes {
        None => by_rows(py, x.len(), count, |some| {
            let rows = out[numbers(&some)].chunks_exact_mut(count);
            x[some].iter().zip(rows).for_each(|(&x, row)| family.values(x, row));
        }),
        Some(slopes) => by_rows(py, x.len(), 2 * count, |some| {
            let rows = out[numbers(&some)].chunks_exact_mut(count);
            let rows = rows.zip(slopes[numbers(&some)].chunks_exact_mut(count));
            x[some]
                .iter()
                .zip(rows)
                .for_each(|(&x, (row, slopes))| family.values_with_derivatives(x, row, slopes));
        }),
    }
}

/// `out[i]` = `P_n(x[i])`, n = `degrees[i]`: classical polynomials with P_n(1) = C(n + α, n).
#[pyfunction]
pub(super) fn classical(
    py: Python<'_>,
    alpha: f64,
    beta: f64,
    degrees: PyReadonlyArray1<'_, usize>,
    x: Input<'_>,
    mut out: Output<'_>,
) -> PyResult<()> {
    let weight = weight(alpha, beta)?;
    let (degrees, x, out) = (degrees.as_slice()?, x.as_slice()?, out.as_slice_mut()?);
    check(x.len(), 1, degrees.len())?;
    check(x.len(), 1, out.len())?;
    let count = 1 + degrees.iter().max().unwrap_or(&0);
    let (mut entries, mut values) = (vec![Entry::EMPTY; count], vec![0.0; count]);
    let family = Family::new(weight, &mut entries);
    let norms: Vec<f64> = norms(&family, degrees, count);
    by_rows(py, x.len(), count, |some| {
        for ((&n, &x), out) in degrees[some.clone()].iter().zip(&x[some.clone()]).zip(&mut out[some]) {
            family.values(x, &mut values[..=n]);
            *out = values[n] * norms[n];
        }
    })
}

/// P_n/p_n of the degrees that occur; 0 elsewhere.
fn norms(family: &Family<'_>, degrees: &[usize], count: usize) -> Vec<f64> {
    let mut norms = vec![0.0; count];
    for &n in degrees {
        if norms[n] == 0.0 {
            norms[n] = family.norm(n);
        }
    }
    norms
}

/// `out[i]` = Σ `f[n]` p_n(`x[i]`) with orthonormal Legendre polynomials, by Clenshaw's recurrence.
#[pyfunction]
pub(super) fn legendre_sum(py: Python<'_>, f: Input<'_>, x: Input<'_>, mut out: Output<'_>) -> PyResult<()> {
    let (f, x, out) = (f.as_slice()?, x.as_slice()?, out.as_slice_mut()?);
    check(x.len(), 1, out.len())?;
    by_rows(py, x.len(), f.len(), |some| {
        for (&x, out) in x[some.clone()].iter().zip(&mut out[some]) {
            *out = legendre::sum(f, x);
        }
    })
}

/// Refuses an array that does not have `count` > 0 numbers for each of `points`.
fn check(points: usize, count: usize, numbers: usize) -> PyResult<()> {
    if count > 0 && points.checked_mul(count) == Some(numbers) {
        Ok(())
    } else {
        Err(misfit("one number per point and polynomial is wanted"))
    }
}
