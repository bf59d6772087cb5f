//! Gauss–Jacobi rules, correctly rounded.
//!
//!   ∫₋₁¹ f(x) (1 − x)^α (1 + x)^β dx = Σ wᵢ f(xᵢ),   π_n(xᵢ) = 0
//!
//! Route: all roots by Laguerre's method with deflation in plain floats (module `laguerre`), then one step
//! with heads and tails, eight nodes side by side (module `polish`). Equal exponents run at half the degree
//! (module `symmetric`). Cost O(n²), no scratch memory.
//!
//! The roots are searched in t, whose distance to the ends ±1 is known to 2⁻⁵³ absolutely. That distance is
//! at least
//!
//!   1 − t ≥ π_n(1)/π_n′(1) = 2 (α + 1)/(n (n + α + β + 1))
//!
//! (1/(1 − t) is one of the terms of π_n′/π_n at 1), and likewise at −1. Where this bound is below
//! [`NEAREST`], which takes exponents near −1 or n above 10⁴, the rule is refused.

use super::error::points;
use super::polish::{Doubles, LANES, Polish};
use super::{RuleError, laguerre, symmetric};
use crate::double::Double;
use crate::jacobi::{Weight, integral, monic::Monic};
use crate::math::const_sqrt;

/// Smallest distance of a node from an end: the error 2⁻⁵³ is then 2⁻²⁶ of it, which after the polish leaves
/// weights within 2 ulp.
const NEAREST: f64 = 1.0 / (1u32 << 27) as f64;

/// Writes the n-point Gauss rule of the weight (1 − x)^α (1 + x)^β, n = `nodes.len()`, nodes ascending.
///
/// Exact for polynomials of degree ≤ 2n − 1; the weights are positive, of sum μ₀ = [`Weight::integral`]. For
/// α = β the rule is symmetric to the last bit. Two things are less than correctly rounded: a node within
/// 10⁻⁸ of 0 (exponents that differ that little) is right to 10⁻²³, and weights of nodes within 10⁻⁷ of an
/// end to 2 ulp. Weights below 10⁻²⁹⁰, which exponents above 100 may have, lose digits and may come out as 0.
///
/// # Errors
/// [`RuleError`] if the slices are empty or differ in length, and [`RuleError::NearEnd`] if an exponent is
/// too near −1 for n (never for α, β ≥ −0.99 and n ≤ 1000); the slices are then left as they were.
pub const fn jacobi(weight: Weight, nodes: &mut [f64], weights: &mut [f64]) -> Result<(), RuleError> {
    let n = match points(nodes, weights) {
        Ok(n) => n,
        Err(error) => return Err(error),
    };
    if end_distance(weight, n) < NEAREST {
        return Err(RuleError::NearEnd);
    }
    let mu_0 = integral(weight);
    if weight.alpha() == weight.beta() {
        even(weight.alpha(), mu_0, nodes, weights);
    } else {
        uneven(weight, mu_0, nodes, weights);
    }
    Ok(())
}

/// The bound of the header on the distance of the roots searched for to the ends.
const fn end_distance(weight: Weight, n: usize) -> f64 {
    let (searched, n) = if weight.alpha() == weight.beta() {
        (symmetric::weight(weight.alpha(), n), n / 2)
    } else {
        (weight, n)
    };
    let (alpha, beta) = (searched.alpha(), searched.beta());
    2.0 * (alpha.min(beta) + 1.0) / (n as f64 * (n as f64 + (alpha + beta + 1.0)))
}

/// Nodes and weights of a rule with different exponents α ≠ β.
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

/// Nodes and weights of a rule with equal exponents α = β.
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
