//! Jacobi polynomials from the end x = 1: the recurrence of differences.
//!
//! With y = 1 − x, s = 2k + α + β, R_k = p_k(x)/p_k(1) and D_{k+1} = R_{k+1} − R_k:
//!
//!   R₀ = 1,  D₀ = 0,   D_{k+1} = (1 − κ_k) D_k − σ_k y R_k,   R_{k+1} = R_k + D_{k+1}
//!   1 − κ_k = k (k + β)(s + 2) / ((k + α + 1)(k + α + β + 1) s),  κ₀ = 1
//!   σ_k = (s + 1)(s + 2) / (2 (k + α + 1)(k + α + β + 1)),        σ₀ = (α + β + 2)/(2 (α + 1))
//!   p_{k+1}(1)²/p_k(1)² = (s + 3)(k + α + β + 1)(k + α + 1) / ((s + 1)(k + 1)(k + β + 1)),   p₀² = 1/μ₀
//!
//! Exact at the end and a few ulp of the local size √(p_k² + p_{k−1}²) elsewhere on the half nearer to it,
//! where the three-term recurrence loses k² ulp. (`recurrence::differences` takes the steps.) No Γ function
//! occurs: norms are products of ratios, in double-double.
//!
//! Reference: NIST Digital Library of Mathematical Functions, 18.9.1, rewritten in differences.

use super::{Weight, integral};
use crate::double::Double;
use crate::recurrence::{Differences, Step};

/// Walks k = 0, 1, … along the end x = 1 of a weight.
#[derive(Clone, Copy)]
pub(super) struct Anchor {
    alpha: Double,
    beta: Double,
    k: usize,
    end: Double,
}

impl Anchor {
    pub(super) const fn new(weight: Weight) -> Anchor {
        Anchor {
            alpha: Double::new(weight.alpha()),
            beta: Double::new(weight.beta()),
            k: 0,
            end: Double::ONE.div(integral(weight)).sqrt(),
        }
    }

    /// p_k(1) at the present k.
    pub(super) const fn end(&self) -> f64 {
        self.end.hi
    }

    /// The coefficients that lead from k to k + 1.
    pub(super) const fn advance(&mut self) -> Step {
        let k = Double::new(self.k as f64);
        let s = k.scale(2.0).add(self.alpha).add(self.beta);
        let right = k.add(self.alpha).add(Double::ONE);
        let left = k.add(self.beta).add(Double::ONE);
        let both = right.add(self.beta);
        let (s_1, s_2) = (s.add(Double::ONE), s.add(Double::new(2.0)));
        // (k + α + β + 1)/(s + 1), which is 1 at k = 0 even where both vanish.
        let share = if self.k == 0 { Double::ONE } else { both.div(s_1) };
        let below = right.mul(share);
        // 1 − κ_k.
        let rest = if self.k == 0 {
            Double::ZERO
        } else {
            k.mul(k.add(self.beta)).mul(s_2).div(below.mul(s_1).mul(s))
        };
        let keep = if rest.hi < 0.5 { 0.0 } else { 1.0 };
        let sigma = s_2.div(below.scale(2.0));
        let growth = s.add(Double::new(3.0)).mul(below).div(left.mul(k.add(Double::ONE)));
        self.end = self.end.mul(growth.sqrt());
        self.k += 1;
        Step { keep, kappa: Double::new(keep).sub(rest).hi, sigma: sigma.hi }
    }
}

/// p_k at an end, and how it goes on from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Start {
    /// Its value at the end.
    pub(super) value: f64,
    /// The step to the next polynomial.
    pub(super) step: Step,
}

/// The polynomials at an end, for k = 0, 1, …; `turn` is −1 at the end −1 of the mirrored weight, else 1.
pub(super) fn anchored(weight: Weight, turn: f64) -> impl Iterator<Item = Start> {
    let (mut anchor, mut sign) = (Anchor::new(weight), 1.0);
    core::iter::repeat_with(move || {
        let value = sign * anchor.end();
        sign *= turn;
        Start { value, step: anchor.advance() }
    })
}

/// Writes p_k(x) from the values at the nearer end and the steps from there.
#[inline(always)]
pub(super) fn write(x: f64, end: impl Iterator<Item = Start>, out: &mut [f64]) {
    let mut walk = Differences::new(1.0 - x.abs());
    for (p, Start { value, step }) in out.iter_mut().zip(end) {
        *p = value * walk.value();
        walk.advance(step);
    }
}

/// Writes p_k(x) and p_k′(x) from the values at the nearer end and the steps from there.
#[inline(always)]
pub(super) fn write_with_derivatives(
    x: f64,
    end: impl Iterator<Item = Start>,
    out: &mut [f64],
    slopes: &mut [f64],
) {
    let outward = if x < 0.0 { 1.0 } else { -1.0 };
    let mut walk = Differences::new(1.0 - x.abs());
    for ((p, d), Start { value, step }) in out.iter_mut().zip(slopes).zip(end) {
        *p = value * walk.value();
        *d = outward * value * walk.slope();
        walk.advance_with_slope(step);
    }
}
