//! Gauss–Jacobi rules, correctly rounded nodes.
//!
//!   ∫₋₁¹ f(x) (1 − x)^α (1 + x)^β dx = Σ wᵢ f(xᵢ),   π_n(xᵢ) = 0
//!
//! Route: all roots by Laguerre's method with deflation in plain floats (module `laguerre`), then one step with
//! heads and tails, eight nodes side by side (module `polish`). Equal exponents run at half the degree (module
//! `symmetric`). Cost O(n²), no scratch memory.

use super::error::points;
use super::polish::{Doubles, LANES, Polish};
use super::{RuleError, laguerre, symmetric};
use crate::double::Double;
use crate::jacobi::{Weight, integral, monic::Monic};
use crate::math::const_sqrt;

/// Writes the n-point Gauss rule of the weight (1 − x)^α (1 + x)^β, n = `nodes.len()`, nodes ascending.
///
/// Exact for polynomials of degree ≤ 2n − 1; the weights are positive, of sum μ₀ = [`Weight::integral`].
/// For α = β the rule is symmetric to the last bit.
///
/// # Errors
/// [`RuleError`] if the slices are empty or differ in length; they are then left as they were.
pub const fn jacobi(weight: Weight, nodes: &mut [f64], weights: &mut [f64]) -> Result<(), RuleError> {
    if let Err(error) = points(nodes, weights) {
        return Err(error);
    }
    let mu_0 = integral(weight);
    if weight.alpha() == weight.beta() {
        even(weight.alpha(), mu_0, nodes, weights);
    } else {
        uneven(weight, mu_0, nodes, weights);
    }
    Ok(())
}

/// Different exponents.
const fn uneven(weight: Weight, mu_0: Double, nodes: &mut [f64], weights: &mut [f64]) {
    let n = nodes.len();
    laguerre::roots(weight, nodes);
    let polish = Polish::new(Monic::new(weight), n, mu_0);
    let mut i = 0;
    while i < n {
        let mut x = Doubles::ZERO;
        let mut l = 0;
        while l < LANES {
            x.hi[l] = nodes[if i + l < n { i + l } else { n - 1 }];
            l += 1;
        }
        let refined = polish.refine(&x);
        let mut l = 0;
        while l < LANES && i + l < n {
            nodes[i + l] += refined.shift[l];
            weights[i + l] = refined.weight.hi[l];
            l += 1;
        }
        i += LANES;
    }
}

/// Equal exponents.
const fn even(alpha: f64, mu_0: Double, nodes: &mut [f64], weights: &mut [f64]) {
    let n = nodes.len();
    let (_, right) = nodes.split_at_mut(n.div_ceil(2));
    laguerre::roots(symmetric::weight(alpha, n), right);
    let mut i = 0;
    while i < right.len() {
        right[i] = const_sqrt(0.5 + 0.5 * right[i]);
        i += 1;
    }
    symmetric::finish(alpha, mu_0, nodes, weights);
}
