//! Gauss–Legendre rules, correctly rounded.
//!
//!   ∫₋₁¹ f(x) dx = Σ wᵢ f(xᵢ),   P_n(xᵢ) = 0,   wᵢ = 2 / ((1 − xᵢ²) P_n′(xᵢ)²)
//!
//! Route: Tricomi's approximation x ≈ (1 − 1/(8n²) + 1/(8n³)) sin(π (n − 1 − 2i)/(2n + 1)), which is
//! right to O(n⁻⁴); two Halley steps in plain floats, eight nodes side by side; one compensated step
//! (module `polish`). Cost O(n²).
//!
//! Reference: F. G. Tricomi, "Sugli zeri dei polinomi sferici ed ultrasferici", Ann. Mat. Pura Appl. 31 (1950).

use core::f64::consts::PI;

use super::RuleError;
use super::error::points;
use super::polish::{LANES, Polish};
use crate::double::Double;
use crate::jacobi::{Weight, monic::Monic};
use crate::math::sin_quadrant;

/// The Gauss–Legendre rule of N points on [−1, 1], computed by the compiler.
///
/// The same bits as [`legendre`] writes at run time. N = 64 costs well under a second of compile time.
pub struct Legendre<const N: usize>;

impl<const N: usize> Legendre<N> {
    /// Nodes, ascending, and their weights.
    pub const RULE: ([f64; N], [f64; N]) = {
        let mut rule = ([0.0; N], [0.0; N]);
        assert!(legendre(&mut rule.0, &mut rule.1).is_ok(), "a Gauss rule has at least one node");
        rule
    };

    /// The nodes, ascending in (−1, 1).
    pub const NODES: [f64; N] = Self::RULE.0;

    /// The weights, positive, of sum 2.
    pub const WEIGHTS: [f64; N] = Self::RULE.1;
}

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
    let polish = Polish::new(Monic::new(Weight::LEGENDRE), n, Double::new(2.0));
    let half = n.div_ceil(2);
    let mut i = 0;
    while i < half {
        let (x, w) = polish.refine(&start(n, i));
        let mut l = 0;
        while l < LANES && i + l < half {
            nodes[i + l] = -x[l];
            weights[i + l] = w[l];
            nodes[n - 1 - i - l] = x[l];
            weights[n - 1 - i - l] = w[l];
            l += 1;
        }
        i += LANES;
    }
    if n % 2 == 1 {
        nodes[n / 2] = 0.0;
    }
    Ok(())
}

/// Floats near the roots number i … i + 7 from the right; lanes beyond the middle repeat the middle one.
const fn start(n: usize, i: usize) -> [f64; LANES] {
    let order = n as f64;
    let shrink = 1.0 - (1.0 - 1.0 / order) / (8.0 * order * order);
    let mut x = [0.0; LANES];
    let mut l = 0;
    while l < LANES {
        let from_middle = (n - 1).saturating_sub(2 * (i + l));
        x[l] = shrink * sin_quadrant(PI * from_middle as f64 / (2 * n + 1) as f64);
        l += 1;
    }
    halley(n, &halley(n, &x))
}

/// One step x − r/(1 − r (2x − n (n+1) r)/(2 (1 − x²))), r = P_n/P_n′, on every lane.
///
/// P_k is scaled to q_{k+1} = 2x q_k − c_k q_{k−1}, c_k = 4k²/(4k² − 1); then (1 − x²) q_n′ = 2n²/(2n − 1) q_{n−1} − n x q_n.
const fn halley(n: usize, x: &[f64; LANES]) -> [f64; LANES] {
    let (mut before, mut last) = ([0.0; LANES], [1.0; LANES]);
    let mut k = 0;
    while k < n {
        let square = (4 * k * k) as f64;
        let c = square / (square - 1.0);
        let mut l = 0;
        while l < LANES {
            let next = 2.0 * x[l] * last[l] - c * before[l];
            before[l] = last[l];
            last[l] = next;
            l += 1;
        }
        k += 1;
    }
    let order = n as f64;
    let factor = 2.0 * order * order / (2.0 * order - 1.0);
    let mut out = [0.0; LANES];
    let mut l = 0;
    while l < LANES {
        let one = (1.0 - x[l]) * (1.0 + x[l]);
        let r = last[l] * one / (factor * before[l] - order * x[l] * last[l]);
        out[l] = x[l] - r / (1.0 - 0.5 * r * (2.0 * x[l] - order * (order + 1.0) * r) / one);
        l += 1;
    }
    out
}
