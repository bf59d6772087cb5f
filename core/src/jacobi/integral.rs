//! The integral of a Jacobi weight, without the Γ function.
//!
//!   μ₀ = ∫₋₁¹ (1 − x)^α (1 + x)^β dx = 2^{p+q−1} B(p, q),   p = α + 1,  q = β + 1
//!
//! Halving B at ½ and applying Euler's transformation to each half leaves series of positive terms and no
//! powers:
//!
//!   μ₀(p, q) = ½ (F(p, q) + F(q, p)),   F(p, q) = 1/p · Σ_{k≥0} Π_{j=1…k} (p + q + j − 1) / (2 (p + j))
//!
//! For p, q ≤ 3/2 the product of k factors is below 2√k · 2⁻ᵏ, so 74 terms leave 2⁻⁶⁹; larger exponents come
//! from
//!
//!   μ₀(p + 1, q) = μ₀(p, q) · 2p/(p + q).
//!
//! For integer exponents only the last formula is used, from μ₀(1, 1) = 2. Everything runs in double-double.
//!
//! Reference: NIST Digital Library of Mathematical Functions, 8.17.7, 8.17.8 and 15.8.1.

use super::Weight;
use crate::double::Double;

/// Terms summed in each half: their tail is below 2⁻⁶⁹ of the sum.
const TERMS: usize = 74;

/// μ₀ of the weight.
pub(crate) const fn integral(weight: Weight) -> Double {
    let (up_p, up_q) = (steps_up(weight.alpha()), steps_up(weight.beta()));
    let p = fraction(weight.alpha(), up_p);
    let q = fraction(weight.beta(), up_q);
    let base = if is_one(p) && is_one(q) {
        Double::new(2.0)
    } else {
        half_integral(p, q).add(half_integral(q, p)).scale(0.5)
    };
    let raised = raise(base, p, q, up_p);
    raise(raised, q, p.add(Double::new(up_p as f64)), up_q)
}

/// An integer next to v > −1, and 0 below ½: an exponent just above 0 must not end up just above −1.
const fn steps_up(v: f64) -> usize {
    if v < 0.5 { 0 } else { (v + 0.5) as usize }
}

/// exponent + 1 − up, in (0, 3/2], exactly.
const fn fraction(exponent: f64, up: usize) -> Double {
    Double::sum(exponent, 1.0 - up as f64)
}

const fn is_one(v: Double) -> bool {
    v.hi == 1.0 && v.lo == 0.0
}

/// F(p, q) for p, q ≤ 3/2.
const fn half_integral(p: Double, q: Double) -> Double {
    let (mut sum, mut term) = (Double::ONE, Double::ONE);
    let mut j = 1;
    while j <= TERMS {
        let above = p.add(q).add(Double::new((j - 1) as f64));
        let below = p.add(Double::new(j as f64)).scale(2.0);
        term = term.mul(above).div(below);
        sum = sum.add(term);
        j += 1;
    }
    sum.div(p)
}

/// μ₀(p + times, q) from μ₀(p, q).
const fn raise(base: Double, p: Double, q: Double, times: usize) -> Double {
    let mut value = base;
    let mut j = 0;
    while j < times {
        let p_j = p.add(Double::new(j as f64));
        value = value.mul(p_j.scale(2.0)).div(p_j.add(q));
        j += 1;
    }
    value
}
