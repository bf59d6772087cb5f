//! Gauss rules.

use pyo3::prelude::*;
use radiosity_core::gauss::{self, RuleError};

use super::{Output, by_rows, misfit, refused, weight, work};

/// Writes the Gauss–Legendre rule of as many points as the arrays have, correctly rounded, in O(n²).
#[pyfunction]
pub(super) fn legendre_rule(py: Python<'_>, nodes: Output<'_>, weights: Output<'_>) -> PyResult<()> {
    let (mut nodes, mut weights) = (nodes, weights);
    let (nodes, weights) = (nodes.as_slice_mut()?, weights.as_slice_mut()?);
    let n = nodes.len();
    if n == 0 || n != weights.len() {
        return Err(misfit("as many weights as nodes are wanted, one or more"));
    }
    // The negative half mirrors the other one.
    let ((below, above), (light, heavy)) = (nodes.split_at_mut(n / 2), weights.split_at_mut(n / 2));
    by_rows(py, above.len(), n, |some| {
        let first = some.start;
        gauss::legendre_part(n, first, &mut above[some.clone()], &mut heavy[some])
            .expect("there are as many nodes as places");
    })?;
    let mirrored = above.iter().zip(&*heavy).rev();
    for ((x, w), (node, weight)) in below.iter_mut().zip(light).zip(mirrored) {
        (*x, *w) = (-node, *weight);
    }
    Ok(())
}

/// Writes the Gauss–Legendre rule of more than 100 points to a few ulp, in O(n).
#[pyfunction]
pub(super) fn asymptotic_rule(py: Python<'_>, nodes: Output<'_>, weights: Output<'_>) -> PyResult<()> {
    write(py, nodes, weights, gauss::legendre_asymptotic)
}

/// Writes the Gauss rule of the weight (1 − x)^α (1 + x)^β.
#[pyfunction]
pub(super) fn jacobi_rule(
    py: Python<'_>,
    alpha: f64,
    beta: f64,
    nodes: Output<'_>,
    weights: Output<'_>,
) -> PyResult<()> {
    let weight = weight(alpha, beta)?;
    write(py, nodes, weights, |x, w| gauss::jacobi(weight, x, w))
}

/// ∫₋₁¹ (1 − x)^α (1 + x)^β dx.
#[pyfunction]
pub(super) fn integral(alpha: f64, beta: f64) -> PyResult<f64> {
    Ok(weight(alpha, beta)?.integral())
}

fn write(
    py: Python<'_>,
    mut nodes: Output<'_>,
    mut weights: Output<'_>,
    rule: impl FnOnce(&mut [f64], &mut [f64]) -> Result<(), RuleError> + Send,
) -> PyResult<()> {
    let (nodes, weights) = (nodes.as_slice_mut()?, weights.as_slice_mut()?);
    // A rule costs O(n²).
    let numbers = nodes.len().saturating_mul(nodes.len());
    work(py, numbers, || rule(nodes, weights)).map_err(refused)
}
