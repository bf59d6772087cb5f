//! The monic Jacobi recurrence in double-double.
//!
//!   π₀ = 1,   π_{k+1} = (x − δ_k) π_k − γ_k π_{k−1}
//!
//! With σ = α + β, d = α − β and s = 2k + σ:
//!
//!   δ_k = −σ d / (s (s + 2)),           δ₀ = −d / (σ + 2)
//!   4γ_k = (s² − σ²)(s² − d²) / (s² (s² − 1)),   γ₁ = 4 (1 + α)(1 + β) / ((σ + 2)² (σ + 3))
//!
//! The special forms at k = 0 and 1 remove the 0/0 at σ = 0 and σ = −1. As k grows δ_k → 0 and 4γ_k → 1.
//! ‖π_k‖² = μ₀ γ₁ … γ_k, and the structure relation that yields derivatives without differentiating is
//!
//!   (1 − x²) π_n′ = n (d/s − x) π_n + (s + 1) γ_n π_{n−1},   s = 2n + σ.
//!
//! Reference: W. Gautschi, Orthogonal Polynomials: Computation and Approximation (2004), table 1.1.

use super::Weight;
use crate::double::{Double, split};

/// Steps whose coefficients are made together, so that their divisions vectorise.
pub(crate) const CHUNK: usize = 8;

/// 1.5 · 2²⁸: adding and subtracting it rounds |v| < 4 to a multiple of 2⁻²⁴.
const GRID: f64 = 402_653_184.0;

/// The largest s, a multiple of ½, for which s² (s² − 1) is an exact float.
const EXACT: f64 = 4870.0;

/// The coefficients δ_k and γ_k of one weight.
#[derive(Clone, Copy)]
pub(crate) struct Monic {
    weight: Weight,
    /// α + β and α − β.
    sigma: Double,
    difference: Double,
    sigma_squared: Double,
    difference_squared: Double,
    /// 2α and 2β are integers: numerators and denominators are then exact floats while s ≤ [`EXACT`].
    halves: bool,
}

/// 2δ_k and 4γ_k of consecutive steps, each as head + tail.
///
/// The head of 2δ is a multiple of 2⁻²⁴, that of 4γ has 26 bits: products with other heads are exact floats.
pub(crate) struct Steps {
    pub(crate) delta: [f64; CHUNK],
    pub(crate) delta_tail: [f64; CHUNK],
    pub(crate) gamma: [f64; CHUNK],
    pub(crate) gamma_tail: [f64; CHUNK],
}

/// v with |v| < 4 as a multiple of 2⁻²⁴ and the rest.
#[inline(always)]
pub(crate) const fn on_grid(v: Double) -> (f64, f64) {
    let head = (v.hi + GRID) - GRID;
    (head, (v.hi - head) + v.lo)
}

impl Monic {
    pub(crate) const fn new(weight: Weight) -> Monic {
        let (alpha, beta) = (weight.alpha(), weight.beta());
        let sigma = Double::sum(alpha, beta);
        let difference = Double::sum(alpha, -beta);
        Monic {
            weight,
            sigma,
            difference,
            sigma_squared: sigma.mul(sigma),
            difference_squared: difference.mul(difference),
            halves: is_integer(2.0 * alpha) && is_integer(2.0 * beta),
        }
    }

    /// α = β: every δ_k is zero and the roots are symmetric.
    pub(crate) const fn is_symmetric(&self) -> bool {
        self.weight.alpha() == self.weight.beta()
    }

    /// s = 2k + α + β.
    #[inline(always)]
    pub(crate) const fn s(&self, k: usize) -> Double {
        Double::new((2 * k) as f64).add(self.sigma)
    }

    /// α − β.
    pub(crate) const fn difference(&self) -> Double {
        self.difference
    }

    /// δ_k, the mean of x for the measure π_k² W.
    #[inline(always)]
    pub(crate) const fn delta(&self, k: usize) -> Double {
        if self.is_symmetric() {
            return Double::ZERO;
        }
        let s = self.s(k);
        if k == 0 {
            return self.difference.neg().div(s.add(Double::new(2.0)));
        }
        if self.halves && s.hi <= EXACT {
            return Double::ratio(-self.sigma.hi * self.difference.hi, s.hi * (s.hi + 2.0));
        }
        self.sigma.mul(self.difference).neg().div(s.mul(s.add(Double::new(2.0))))
    }

    /// 4γ_k for k ≥ 1.
    #[inline(always)]
    pub(crate) const fn four_gamma(&self, k: usize) -> Double {
        let s = self.s(k);
        if self.halves && s.hi <= EXACT && s.hi > 1.0 {
            let square = s.hi * s.hi;
            let numerator = (square - self.sigma_squared.hi) * (square - self.difference_squared.hi);
            return Double::ratio(numerator, square * (square - 1.0));
        }
        if k == 1 {
            return self.first_four_gamma(s);
        }
        let square = s.mul(s);
        let numerator = square.sub(self.sigma_squared).mul(square.sub(self.difference_squared));
        numerator.div(square.mul(square.sub(Double::ONE)))
    }

    /// 2δ_k and 4γ_k for k = `first` … `first` + 7, with γ₀ = 0.
    #[inline]
    pub(crate) const fn steps(&self, first: usize) -> Steps {
        let zero = [0.0; CHUNK];
        let mut steps = Steps { delta: zero, delta_tail: zero, gamma: zero, gamma_tail: zero };
        let exact = self.halves && self.s(first + CHUNK).hi <= EXACT;
        if exact {
            self.exact_steps(first, &mut steps);
        } else {
            self.general_steps(first, &mut steps);
        }
        let special = if first == 0 && !(exact && self.is_regular()) { 2 } else { 0 };
        let mut k = 0;
        while k < special {
            (steps.delta[k], steps.delta_tail[k]) = on_grid(self.delta(k).scale(2.0));
            let gamma = if k == 0 { Double::ZERO } else { self.four_gamma(k) };
            let (head, rest) = split(gamma.hi);
            (steps.gamma[k], steps.gamma_tail[k]) = (head, rest + gamma.lo);
            k += 1;
        }
        steps
    }

    /// [`Monic::steps`] in plain floats: (2δ_k, 4γ_k).
    #[inline]
    pub(crate) const fn coarse_steps(&self, first: usize) -> ([f64; CHUNK], [f64; CHUNK]) {
        let (alpha, beta, sigma) = (self.weight.alpha(), self.weight.beta(), self.sigma.hi);
        let mean = -2.0 * sigma * self.difference.hi;
        let (mut delta, mut gamma) = ([0.0; CHUNK], [0.0; CHUNK]);
        let mut l = 0;
        while l < CHUNK {
            let k = (first + l) as f64;
            let s = 2.0 * k + sigma;
            let square = s * (s * s - 1.0);
            let inverse = 1.0 / (s * square * (s + 2.0));
            delta[l] = mean * square * inverse;
            gamma[l] = 16.0 * k * (k + sigma) * (k + alpha) * (k + beta) * (s + 2.0) * inverse;
            l += 1;
        }
        if first == 0 {
            (delta[0], gamma[0]) = (2.0 * self.delta(0).hi, 0.0);
            (delta[1], gamma[1]) = (2.0 * self.delta(1).hi, self.four_gamma(1).hi);
        }
        (delta, gamma)
    }

    /// The formulas of the header for k ≥ 2 are nowhere 0/0 at k = 0 and 1 either.
    const fn is_regular(&self) -> bool {
        let sigma = self.sigma.hi;
        sigma != 0.0 && sigma != 1.0 && sigma != -1.0
    }

    /// [`Monic::steps`] from double-double numerators and denominators; k = 0 and 1 may come out undefined.
    #[inline(always)]
    const fn general_steps(&self, first: usize, steps: &mut Steps) {
        let mean = self.sigma.mul(self.difference).scale(-2.0);
        let mut l = 0;
        while l < CHUNK {
            let s = Double::new((2 * (first + l)) as f64).add(self.sigma);
            let below = s.mul(s.add(Double::new(2.0)));
            let head = (mean.hi / below.hi + GRID) - GRID;
            let rest = mean.sub(below.mul(Double::new(head)));
            steps.delta[l] = head;
            steps.delta_tail[l] = rest.hi / below.hi;

            let square = s.mul(s);
            let above = square.sub(self.sigma_squared).mul(square.sub(self.difference_squared));
            let below = square.mul(square.sub(Double::ONE));
            let (head, _) = split(above.hi / below.hi);
            let rest = above.sub(below.mul(Double::new(head)));
            steps.gamma[l] = head;
            steps.gamma_tail[l] = rest.hi / below.hi;
            l += 1;
        }
    }

    /// [`Monic::steps`] where numerators and denominators are exact floats; k = 0 and 1 may come out
    /// undefined.
    #[inline(always)]
    const fn exact_steps(&self, first: usize, steps: &mut Steps) {
        let mean = -2.0 * self.sigma.hi * self.difference.hi;
        let mut l = 0;
        while l < CHUNK {
            let s = (2 * (first + l)) as f64 + self.sigma.hi;
            let below = s * (s + 2.0);
            let inverse = 1.0 / below;
            let head = (mean * inverse + GRID) - GRID;
            steps.delta[l] = head;
            steps.delta_tail[l] = (mean - head * below) * inverse;

            let square = s * s;
            let above = (square - self.sigma_squared.hi) * (square - self.difference_squared.hi);
            let below = square * (square - 1.0);
            let inverse = 1.0 / below;
            let (head, _) = split(above * inverse);
            let (below_head, below_tail) = split(below);
            steps.gamma[l] = head;
            steps.gamma_tail[l] = ((above - head * below_head) - head * below_tail) * inverse;
            l += 1;
        }
    }

    /// 4γ₁ = 16 (1 + α)(1 + β) / (s² (s + 1)), s = α + β + 2.
    const fn first_four_gamma(&self, s: Double) -> Double {
        let one = Double::sum(1.0, self.weight.alpha()).mul(Double::sum(1.0, self.weight.beta()));
        one.scale(16.0).div(s.mul(s).mul(s.add(Double::ONE)))
    }
}

/// v, of moderate size, is an integer.
const fn is_integer(v: f64) -> bool {
    v as i64 as f64 == v
}
