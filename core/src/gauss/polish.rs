//! The last step of a correctly rounded rule: from a float near a root to the rounded root and its weight.
//!
//! Let x be a float and r the root of π_n next to it. One evaluation of π_n and π_{n−1} at x, with twice the
//! working precision, gives both node and weight; no second one is needed. With s = 2n + α + β,
//! d = α − β, λ = n (n + α + β + 1), m = d + (α + β) x:
//!
//!   N = (1 − x²) π_n′(x) = n (d/s − x) π_n + (s + 1) γ_n π_{n−1}
//!   q = −π_n (1 − x²) / N                                   (Newton)
//!   r = x + q / (1 + q (m + 2x + λq) / (2 (1 − x²)))        (Halley, π_n″ from the differential equation)
//!   w = (s + 1) ‖π_n‖² (1 − x²) / N² · (1 − ((2x + 2m) (r−x) + λ (r−x)²) / (1 − x²))
//!
//! The last bracket carries 1 − x² and N from x to r. It matters: d log w/dx grows like n² at the ends, which is
//! why rules that evaluate the weight at the rounded node lose n² half-ulps there.
//!
//! Twice the working precision is had by a compensated recurrence: π_k is a float, the rounding errors of each
//! step are computed exactly and carried along to first order by the same recurrence in plain floats. What is
//! neglected is of second order, about (n · 2⁻⁵³)². Each π_k is scaled by a power of two that keeps
//! ‖π_k‖² within [½, 2) of μ₀, so that neither large exponents nor large n leave the range of floats.
//! [`LANES`] nodes are treated side by side.

use crate::double::{Double, product_error, split, two_sum};
use crate::jacobi::monic::Monic;

/// Nodes treated side by side.
pub(super) const LANES: usize = 8;

/// What all nodes of one rule share.
#[derive(Clone, Copy)]
pub(super) struct Polish {
    monic: Monic,
    n: usize,
    mu_0: Double,
}

/// π_k at every lane: value + error, the value also in two halves.
#[derive(Clone, Copy)]
struct Row {
    value: [f64; LANES],
    head: [f64; LANES],
    tail: [f64; LANES],
    error: [f64; LANES],
}

/// π_n and π_{n−1} with their common factors.
struct Evaluated {
    last: Row,
    before: Row,
    /// γ_n times the factor between the scales of π_n and π_{n−1}.
    gamma: Double,
    /// ‖π_n‖²/μ₀ in the scale of π_n.
    norm: Double,
}

impl Row {
    const fn constant(value: f64) -> Row {
        Row { value: [value; LANES], head: [value; LANES], tail: [0.0; LANES], error: [0.0; LANES] }
    }
}

/// The power of two s for which norm · γ s² comes into [½, 2).
const fn scale(norm: f64, four_gamma: f64) -> f64 {
    let mut s = 2.0;
    let mut next = norm * four_gamma;
    while next < 0.5 {
        next *= 4.0;
        s *= 2.0;
    }
    while next >= 2.0 {
        next *= 0.25;
        s *= 0.5;
    }
    s
}

impl Polish {
    /// For the n-point rule of the weight of `monic`, of integral `mu_0`.
    pub(super) const fn new(monic: Monic, n: usize, mu_0: Double) -> Polish {
        Polish { monic, n, mu_0 }
    }

    /// Floats near roots → the rounded roots and their weights.
    #[inline]
    pub(super) const fn refine(&self, x: &[f64; LANES]) -> ([f64; LANES], [f64; LANES]) {
        let at = self.evaluate(x);
        let s = self.monic.s(self.n);
        let s_1 = s.add(Double::ONE);
        let shared = Shared {
            n: self.n as f64,
            ratio: self.monic.difference().hi / s.hi,
            lambda: self.n as f64 * (s.hi - self.n as f64 + 1.0),
            sigma: s.hi - 2.0 * self.n as f64,
            difference: self.monic.difference().hi,
            before: s_1.mul(at.gamma),
            weight: s_1.mul(self.mu_0).mul(at.norm),
        };
        let (mut nodes, mut weights) = ([0.0; LANES], [0.0; LANES]);
        let mut l = 0;
        while l < LANES {
            let last = Double::sum(at.last.value[l], at.last.error[l]);
            let before = Double::sum(at.before.value[l], at.before.error[l]);
            (nodes[l], weights[l]) = shared.finish(x[l], last.hi, before);
            l += 1;
        }
        (nodes, weights)
    }

    /// The compensated recurrence from π₀ to π_n.
    #[inline(always)]
    const fn evaluate(&self, x: &[f64; LANES]) -> Evaluated {
        let mut before = Row::constant(0.0);
        let mut last = Row::constant(1.0);
        let mut gamma = Double::ZERO;
        let mut norm = Double::ONE;
        let mut k = 0;
        while k < self.n {
            let four_gamma = self.monic.four_gamma(k + 1);
            let s = scale(norm.hi, four_gamma.hi);
            let next = step(x, self.monic.delta(k), gamma, s, &last, &before);
            before = last;
            last = next;
            gamma = four_gamma.scale(0.25 * s);
            norm = norm.mul(gamma).scale(s);
            k += 1;
        }
        Evaluated { last, before, gamma, norm }
    }
}

/// s ((x − δ) π_k − γ π_{k−1}) with the exact rounding errors of the four operations.
#[inline(always)]
const fn step(x: &[f64; LANES], delta: Double, gamma: Double, s: f64, last: &Row, before: &Row) -> Row {
    let gamma_split = split(gamma.hi);
    let mut next = Row::constant(0.0);
    let mut l = 0;
    while l < LANES {
        let (u, u_error) = two_sum(x[l], -delta.hi);
        let t = u * last.value[l];
        let t_error = product_error(t, split(u), (last.head[l], last.tail[l]));
        let r = gamma.hi * before.value[l];
        let r_error = product_error(r, gamma_split, (before.head[l], before.tail[l]));
        let (v, v_error) = two_sum(t, -r);
        let carried = u * last.error[l] - gamma.hi * before.error[l];
        let small = (u_error - delta.lo) * last.value[l] - gamma.lo * before.value[l];
        next.value[l] = s * v;
        next.error[l] = s * (carried + (small + ((t_error - r_error) + v_error)));
        (next.head[l], next.tail[l]) = split(next.value[l]);
        l += 1;
    }
    next
}

/// The factors of the formulas in the header that do not depend on the node.
struct Shared {
    n: f64,
    /// d/s.
    ratio: f64,
    lambda: f64,
    sigma: f64,
    difference: f64,
    /// (s + 1) γ_n.
    before: Double,
    /// (s + 1) ‖π_n‖².
    weight: Double,
}

impl Shared {
    /// x, π_n(x), π_{n−1}(x) → (r, w).
    #[inline(always)]
    const fn finish(&self, x: f64, last: f64, before: Double) -> (f64, f64) {
        let one = Double::sum(1.0, -x).mul(Double::sum(1.0, x));
        let derivative = self.before.mul(before).add(Double::new(self.n * (self.ratio - x) * last));
        let m = self.difference + self.sigma * x;
        let newton = -last * one.hi / derivative.hi;
        let dx = newton / (1.0 + 0.5 * newton * (m + 2.0 * x + self.lambda * newton) / one.hi);
        let w = self.weight.mul(one).div(derivative.mul(derivative));
        let carry = -dx * (2.0 * (x + m) + self.lambda * dx) / one.hi;
        (x + dx, w.hi + (w.lo + w.hi * carry))
    }
}
