//! Gauss–Legendre rules, correctly rounded.
//!
//!   ∫₋₁¹ f(x) dx = Σ wᵢ f(xᵢ),   P_n(xᵢ) = 0,   wᵢ = 2 / ((1 − xᵢ²) P_n′(xᵢ)²)
//!
//! Route: Tricomi's approximation x ≈ (1 − 1/(8n²) + 1/(8n³)) sin(π (n − 1 − 2i)/(2n + 1)), which is right to
//! O(n⁻⁴); one Halley step in plain floats, eight nodes side by side; one step with heads and tails (module
//! `polish`), both at half the degree (module `symmetric`). Cost O(n²).
//!
//! Reference: F. G. Tricomi, "Sugli zeri dei polinomi sferici ed ultrasferici", Ann. Mat. Pura Appl. 31
//! (1950).

use core::f64::consts::PI;

use super::RuleError;
use super::error::points;
use super::polish::{LANES, Lane};
use super::symmetric::{self, Finish, root_shift};
use crate::double::Double;
use crate::jacobi::monic::{CHUNK, Monic};
use crate::math::sin_quadrant;

/// Writes the n-point Gauss–Legendre rule on [−1, 1], n = `nodes.len()`, nodes ascending.
///
/// Exact for polynomials of degree ≤ 2n − 1. Nodes and weights are correctly rounded (0.5 ulp measured
/// for n ≤ 1000), the rule is symmetric to the last bit, and the middle node of an odd rule is 0.
///
/// # Errors
/// [`RuleError`] if the slices are empty or differ in length; they are then left as they were.
pub const fn legendre(nodes: &mut [f64], weights: &mut [f64]) -> Result<(), RuleError> {
    let n = match points(nodes, weights) {
        Ok(n) => n,
        Err(error) => return Err(error),
    };
    let (_, upper_nodes) = nodes.split_at_mut(n / 2);
    let (_, upper_weights) = weights.split_at_mut(n / 2);
    upper(n, 0, upper_nodes, upper_weights);
    symmetric::mirror(nodes, weights);
    Ok(())
}

/// Writes a part of the same rule, to the last bit, where all of it would take too long at once: its nodes of
/// the numbers `first`, `first` + 1, … from the middle to +1, and their weights. Number 0 is the least node
/// that is not negative; the others of the n nodes mirror them, with the same weights.
///
/// ```
/// use radiosity_core::gauss;
///
/// let (mut x, mut w) = ([0.0; 7], [0.0; 7]);
/// gauss::legendre(&mut x, &mut w)?;
/// let (mut part_x, mut part_w) = ([0.0; 2], [0.0; 2]);
/// gauss::legendre_part(7, 1, &mut part_x, &mut part_w)?;
/// assert_eq!((part_x, part_w), ([x[4], x[5]], [w[4], w[5]]));
/// # Ok::<(), gauss::RuleError>(())
/// ```
///
/// # Errors
/// [`RuleError`] if the slices are empty or differ in length, or [`RuleError::Beyond`] if there are not so
/// many nodes from `first` on; they are then left as they were.
pub const fn legendre_part(
    n: usize,
    first: usize,
    nodes: &mut [f64],
    weights: &mut [f64],
) -> Result<(), RuleError> {
    let count = match points(nodes, weights) {
        Ok(count) => count,
        Err(error) => return Err(error),
    };
    let all = n.div_ceil(2);
    if first >= all || count > all - first {
        return Err(RuleError::Beyond);
    }
    upper(n, first, nodes, weights);
    Ok(())
}

/// The nodes of the numbers `first`, `first` + 1, … from the middle to +1.
const fn upper(n: usize, first: usize, nodes: &mut [f64], weights: &mut [f64]) {
    let (half, odd) = (n / 2, n % 2);
    let finish = Finish::new(0.0, n, Double::new(2.0));
    let mut i = 0;
    if odd == 1 && first == 0 {
        (nodes[0], weights[0]) = (0.0, finish.middle());
        i = 1;
    }
    let monic = Monic::new(symmetric::weight(0.0, n));
    while i < nodes.len() {
        // The root number k from the right is the node number half − 1 − k of the positive ones.
        let x = halley(&monic, half, &start(n, half + odd - 1 - first - i));
        finish.write(&x, i, nodes, weights);
        i += LANES;
    }
}

/// Floats near the roots number i, i − 1, … from the right; lanes beyond the last repeat it.
const fn start(n: usize, i: usize) -> Lane {
    let order = n as f64;
    let shrink = 1.0 - (1.0 - 1.0 / order) / (8.0 * order * order);
    let mut x = [0.0; LANES];
    let mut l = 0;
    while l < LANES {
        let from_middle = n - 1 - 2 * i.saturating_sub(l);
        x[l] = shrink * sin_quadrant(PI * from_middle as f64 / (2 * n + 1) as f64);
        l += 1;
    }
    x
}

/// One Halley step for π_m(2x² − 1) on every lane, in the notation of module `polish`.
const fn halley(monic: &Monic, m: usize, x: &Lane) -> Lane {
    let (last, before) = evaluate(monic, m, x);
    let (order, s, d) = (m as f64, monic.s(m).hi, monic.difference().hi);
    let factor = 0.5 * (s + 1.0) * monic.four_gamma(m).hi;
    let mut out = [0.0; LANES];
    let mut l = 0;
    while l < LANES {
        let z = 2.0 * x[l] * x[l] - 1.0;
        let one = (1.0 - z) * (1.0 + z);
        let q = -last[l] * one / (factor * before[l] + order * (d / s - z) * last[l]);
        let curvature = d + (s - 2.0 * order + 2.0) * z + order * (s - order + 1.0) * q;
        out[l] = x[l] + root_shift(x[l], q / (1.0 + 0.5 * q * curvature / one));
        l += 1;
    }
    out
}

/// π̂_m and π̂_{m−1} at 2x² − 1, in plain floats.
#[inline(always)]
const fn evaluate(monic: &Monic, m: usize, x: &Lane) -> (Lane, Lane) {
    let (mut before, mut last) = ([0.0; LANES], [1.0; LANES]);
    let mut k = 0;
    while k < m {
        let (delta, gamma) = monic.coarse_steps(k);
        let mut l = 0;
        while l < CHUNK && k < m {
            if l % 2 == 0 {
                forward(x, delta[l] + 2.0, gamma[l], &last, &mut before);
            } else {
                forward(x, delta[l] + 2.0, gamma[l], &before, &mut last);
            }
            l += 1;
            k += 1;
        }
    }
    if m.is_multiple_of(2) { (last, before) } else { (before, last) }
}

/// Replaces π̂_{k−1} in `before` by π̂_{k+1} = (4x² − δ) π̂_k − γ π̂_{k−1}.
#[inline(always)]
const fn forward(x: &Lane, delta: f64, gamma: f64, last: &Lane, before: &mut Lane) {
    let mut l = 0;
    while l < LANES {
        before[l] = (4.0 * x[l] * x[l] - delta) * last[l] - gamma * before[l];
        l += 1;
    }
}
