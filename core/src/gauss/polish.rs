//! The last step of a correctly rounded rule: from a float near a root to the root and its weight.
//!
//! Let x be a number near the root r of π_n. One evaluation of π_n and π_{n−1} at x, with about 77 bits,
//! gives both node and weight; no second one is needed. With σ = α + β, s = 2n + σ, d = α − β, λ = n
//! (n + σ + 1), m = d + σx:
//!
//!   N = (1 − x²) π_n′ = n (d/s − x) π_n + (s + 1) γ_n π_{n−1}
//!   q = −π_n/π_n′ = −π_n (1 − x²)/N                         (Newton)
//!   c = π_n″/π_n′ = (m + 2x + λq)/(1 − x²)                  (differential equation)
//!   h = r − x = q/(1 + q c/2)                               (Halley)
//!   w = (s + 1) ‖π_n‖² (1 − r²)/N(r)²
//!     = (s + 1) ‖π_n‖² (1 − x²)/N² · (1 + a)/(1 + b)²
//!   a = −h (2x + h)/(1 − x²),   b = h (m + λq + h (σ − λ + m c)/2)/(1 − x²)
//!
//! The last factor carries 1 − x² and N from x to r. It matters: d log w/dx grows like n² at the ends, which
//! is why rules that evaluate the weight at the rounded node lose n² half-ulps there. What is neglected is of
//! third order in h over the distance to the next root: numbers to 10⁻⁶ of that distance are near enough.
//!
//! The recurrence runs on π̂_k = 2ᵏ π_k, split into a head of 26 bits and a float tail; 2x, 2δ_k and 4γ_k are
//! split likewise, so that every product of heads is an exact float and only one sum per step needs its
//! rounding error:
//!
//!   π̂_{k+1} = 2 (x − δ_k) π̂_k − 4γ_k π̂_{k−1},   ‖π̂_k‖² = μ₀ · 4γ₁ ⋯ 4γ_k
//!
//! A power of two keeps the norm within 2^±64 when α or β is large. [`LANES`] nodes are treated side by side:
//! about 25 operations a step and node, all of which vectorise.

use crate::double::{Double, split, two_sum};
use crate::jacobi::monic::{CHUNK, Monic, Steps, on_grid};

/// Nodes per group: one AVX-512 register of f64, two of AVX.
pub(super) const LANES: usize = 8;

/// One number per lane.
pub(super) type Lane = [f64; LANES];

/// Data that all nodes of one n-point rule share: the monic polynomials, n and the integral of the weight.
pub(super) struct Polish {
    monic: Monic,
    n: usize,
    mu_0: Double,
}

/// One double-double number per lane, in a layout that vectorises.
pub(super) struct Doubles {
    pub(super) hi: Lane,
    pub(super) lo: Lane,
}

/// Where the roots are, seen from the points given, and the weights of the rule there.
pub(super) struct Refined {
    /// r − x.
    pub(super) shift: Lane,
    pub(super) weight: Doubles,
}

impl Doubles {
    pub(super) const ZERO: Doubles = Doubles { hi: [0.0; LANES], lo: [0.0; LANES] };

    #[inline(always)]
    pub(super) const fn get(&self, l: usize) -> Double {
        Double { hi: self.hi[l], lo: self.lo[l] }
    }

    #[inline(always)]
    pub(super) const fn set(&mut self, l: usize, v: Double) {
        (self.hi[l], self.lo[l]) = (v.hi, v.lo);
    }
}

/// One number per lane: head (26 bits) + tail.
struct Row {
    head: Lane,
    tail: Lane,
}

impl Row {
    const fn constant(value: f64) -> Row {
        Row { head: [value; LANES], tail: [0.0; LANES] }
    }

    const fn scale(&mut self, factor: f64) {
        let mut l = 0;
        while l < LANES {
            self.head[l] *= factor;
            self.tail[l] *= factor;
            l += 1;
        }
    }
}

/// π̂_n, π̂_{n−1} and ‖π̂_n‖²/μ₀, up to a common power of two c, c and c².
struct Evaluated {
    last: Row,
    before: Row,
    norm: Double,
}

impl Polish {
    /// For the n-point rule of the weight of `monic`, whose integral is `mu_0`.
    pub(super) const fn new(monic: Monic, n: usize, mu_0: Double) -> Polish {
        Polish { monic, n, mu_0 }
    }

    /// From numbers near roots to the distances of the roots from them, and the weights there.
    #[inline]
    pub(super) const fn refine(&self, x: &Doubles) -> Refined {
        let at = self.evaluate(x);
        let node = Node::new(self, &at);
        let mut refined = Refined { shift: [0.0; LANES], weight: Doubles::ZERO };
        let mut l = 0;
        while l < LANES {
            let last = at.last.head[l] + at.last.tail[l];
            let before = Double::sum(at.before.head[l], at.before.tail[l]);
            let (shift, weight) = node.finish(x.get(l), last, before);
            refined.shift[l] = shift;
            refined.weight.set(l, weight);
            l += 1;
        }
        refined
    }

    /// The recurrence from π̂₀ to π̂_n.
    #[inline]
    const fn evaluate(&self, x: &Doubles) -> Evaluated {
        let mut twice = Row::constant(0.0);
        let mut l = 0;
        while l < LANES {
            (twice.head[l], twice.tail[l]) = on_grid(x.get(l).scale(2.0));
            l += 1;
        }
        let (mut last, mut before) = (Row::constant(1.0), Row::constant(0.0));
        let mut norm = Double::ONE;
        let mut k = 0;
        while k < self.n {
            let steps = self.monic.steps(k);
            let mut l = 0;
            while l < CHUNK && k < self.n {
                if l % 2 == 0 {
                    step(&twice, &steps, l, &last, &mut before);
                } else {
                    step(&twice, &steps, l, &before, &mut last);
                }
                if k > 0 {
                    norm = norm.mul(Double::renormalised(steps.gamma[l], steps.gamma_tail[l]));
                }
                l += 1;
                k += 1;
            }
            rescale(&mut last, &mut before, &mut norm);
        }
        if self.n % 2 == 1 {
            core::mem::swap(&mut last, &mut before);
        }
        Evaluated { last, before, norm: norm.mul(self.monic.four_gamma(self.n)) }
    }
}

/// Bounds 2⁻⁶⁴ and 2⁶⁴ of the norm between rescalings: far from overflow, and exact powers.
/// Any power between would do as well.
const LOW: f64 = 1.0 / HIGH;
const HIGH: f64 = 18_446_744_073_709_551_616.0;

/// Brings a norm that has left [2⁻⁶⁴, 2⁶⁴] back towards 1, by an exact factor.
const fn rescale(last: &mut Row, before: &mut Row, norm: &mut Double) {
    if norm.hi < LOW || norm.hi > HIGH {
        let factor = if norm.hi < LOW { HIGH } else { LOW };
        last.scale(factor);
        before.scale(factor);
        *norm = norm.scale(factor * factor);
    }
}

/// Replaces π̂_{k−1} in `before` by π̂_{k+1} = (2x − 2δ) π̂_k − 4γ π̂_{k−1}, with the coefficients number
/// `at`.
#[inline]
const fn step(twice: &Row, steps: &Steps, at: usize, last: &Row, before: &mut Row) {
    let (delta, delta_tail) = (steps.delta[at], steps.delta_tail[at]);
    let (gamma, gamma_tail) = (steps.gamma[at], steps.gamma_tail[at]);
    let mut l = 0;
    while l < LANES {
        let u = twice.head[l] - delta;
        let du = twice.tail[l] - delta_tail;
        let (v, error) = two_sum(u * last.head[l], -(gamma * before.head[l]));
        let coarse = du * last.head[l] - gamma_tail * before.head[l];
        let fine = (u + du) * last.tail[l] - (gamma + gamma_tail) * before.tail[l];
        let tail = coarse + (fine + error);
        let (head, _) = split(v + tail);
        before.head[l] = head;
        before.tail[l] = (v - head) + tail;
        l += 1;
    }
}

/// The factors of the formulas in the header that do not depend on the node.
struct Node {
    n: f64,
    lambda: f64,
    sigma: f64,
    difference: f64,
    /// d/s.
    ratio: f64,
    /// (s + 1) γ_n in the scale of π̂_n, π̂_{n−1}.
    before: Double,
    /// (s + 1) ‖π̂_n‖².
    weight: Double,
}

impl Node {
    const fn new(polish: &Polish, at: &Evaluated) -> Node {
        let (monic, n) = (&polish.monic, polish.n as f64);
        let s = monic.s(polish.n);
        let after = s.add(Double::ONE);
        Node {
            n,
            lambda: n * (s.hi - n + 1.0),
            sigma: s.hi - 2.0 * n,
            difference: monic.difference().hi,
            ratio: monic.difference().hi / s.hi,
            before: after.mul(monic.four_gamma(polish.n)).scale(0.5),
            weight: after.mul(polish.mu_0).mul(at.norm),
        }
    }

    /// x, π̂_n(x), π̂_{n−1}(x) → (r − x, w).
    #[inline(always)]
    const fn finish(&self, x: Double, last: f64, before: Double) -> (f64, Double) {
        let one = Double::ONE.sub(x).mul(Double::ONE.add(x));
        let derivative = self.before.mul(before).add(Double::new(self.n * (self.ratio - x.hi) * last));
        let m = self.difference + self.sigma * x.hi;
        let inverse = 1.0 / one.hi;
        let newton = -last * one.hi / derivative.hi;
        let curvature = (m + 2.0 * x.hi + self.lambda * newton) * inverse;
        let shift = newton / (1.0 + 0.5 * newton * curvature);
        let a = -shift * (2.0 * x.hi + shift) * inverse;
        let second = self.sigma - self.lambda + m * curvature;
        let b = shift * (m + self.lambda * newton + 0.5 * shift * second) * inverse;
        let carry = (a - b * (2.0 + b)) / ((1.0 + b) * (1.0 + b));
        // Two divisions, since N² may leave the range of floats where the weight is small.
        let w = self.weight.mul(one).div(derivative).div(derivative);
        (shift, Double::renormalised(w.hi, w.lo + w.hi * carry))
    }
}
