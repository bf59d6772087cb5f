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
use crate::double::Double;

/// The largest s for which s² (s² − 1) is an exact float.
const EXACT: f64 = 9741.0;

/// The coefficients δ_k and γ_k of one weight.
#[derive(Clone, Copy)]
pub(crate) struct Monic {
    weight: Weight,
    /// α + β and α − β.
    sigma: Double,
    difference: Double,
    sigma_squared: Double,
    difference_squared: Double,
    /// α and β are integers: numerators and denominators are then exact floats while s ≤ [`EXACT`].
    integer: bool,
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
            integer: alpha as i64 as f64 == alpha && beta as i64 as f64 == beta,
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
        if self.integer && s.hi <= EXACT {
            return Double::ratio(-self.sigma.hi * self.difference.hi, s.hi * (s.hi + 2.0));
        }
        self.sigma.mul(self.difference).neg().div(s.mul(s.add(Double::new(2.0))))
    }

    /// 4γ_k for k ≥ 1.
    #[inline(always)]
    pub(crate) const fn four_gamma(&self, k: usize) -> Double {
        let s = self.s(k);
        if k == 1 {
            return self.first_four_gamma(s);
        }
        if self.integer && s.hi <= EXACT {
            let square = s.hi * s.hi;
            let numerator = (square - self.sigma_squared.hi) * (square - self.difference_squared.hi);
            return Double::ratio(numerator, square * (square - 1.0));
        }
        let square = s.mul(s);
        let numerator = square.sub(self.sigma_squared).mul(square.sub(self.difference_squared));
        numerator.div(square.mul(square.sub(Double::ONE)))
    }

    /// 4γ₁ = 16 (1 + α)(1 + β) / (s² (s + 1)), s = α + β + 2.
    const fn first_four_gamma(&self, s: Double) -> Double {
        let one = Double::sum(1.0, self.weight.alpha()).mul(Double::sum(1.0, self.weight.beta()));
        one.scale(16.0).div(s.mul(s).mul(s.add(Double::ONE)))
    }
}
