//! Rules of symmetric weights (1 − x²)^α at half the degree.
//!
//! With z = 2x² − 1 the polynomials of even and odd degree are Jacobi polynomials of half the degree,
//!
//!   π_{2m}(x) ∝ P_m^(α,−½)(z),   π_{2m+1}(x) ∝ x P_m^(α,½)(z),
//!
//! so that a rule of n points costs a recurrence of ⌊n/2⌋ steps at ⌊n/2⌋ points. If ζ is a root, of weight ω
//! in the m-point rule of (α, ∓½) scaled to sum 1, the nodes are ±√((1 + ζ)/2) and, μ₀ being the integral of
//! (1 − x²)^α,
//!
//!   n = 2m:      w = ω μ₀ / 2
//!   n = 2m + 1:  w = ω μ₀ / (2 (2α + 3) x²),   in the middle  w₀ = μ₀ Π_{j=1…m} j (j + α) / ((j + ½)(j + α + ½))
//!
//! where μ₀/(2α + 3) is the integral of x² (1 − x²)^α.
//!
//! Reference: G. Szegő, Orthogonal Polynomials, §4.1.

use super::polish::{Doubles, LANES, Lane, Polish};
use crate::double::Double;
use crate::jacobi::{Weight, monic::Monic};

/// The weight whose ⌊n/2⌋-point rule yields the n-point rule of (1 − x²)^α.
pub(super) const fn weight(alpha: f64, n: usize) -> Weight {
    Weight::valid(alpha, if n % 2 == 1 { 0.5 } else { -0.5 })
}

/// Completes a rule whose last ⌊n/2⌋ nodes are floats near the positive roots, ascending.
pub(super) const fn finish(alpha: f64, mu_0: Double, nodes: &mut [f64], weights: &mut [f64]) {
    let n = nodes.len();
    let finish = Finish::new(alpha, n, mu_0);
    let mut i = n / 2;
    if n % 2 == 1 {
        (nodes[i], weights[i]) = (0.0, finish.middle());
        i += 1;
    }
    while i < n {
        let mut x = [0.0; LANES];
        let mut l = 0;
        while l < LANES {
            x[l] = nodes[if i + l < n { i + l } else { n - 1 }];
            l += 1;
        }
        finish.write(&x, i, nodes, weights);
        i += LANES;
    }
    mirror(nodes, weights);
}

/// Writes the negative half of a rule from the other one.
pub(super) const fn mirror(nodes: &mut [f64], weights: &mut [f64]) {
    let n = nodes.len();
    let mut i = 0;
    while i < n / 2 {
        (nodes[i], weights[i]) = (-nodes[n - 1 - i], weights[n - 1 - i]);
        i += 1;
    }
}

/// Data that all nodes of one n-point rule of (1 − x²)^α share.
pub(super) struct Finish {
    alpha: f64,
    n: usize,
    mu_0: Double,
    polish: Polish,
}

impl Finish {
    /// For the n-point rule of (1 − x²)^α, whose integral is `mu_0`.
    pub(super) const fn new(alpha: f64, n: usize, mu_0: Double) -> Finish {
        let polish = Polish::new(Monic::new(weight(alpha, n)), n / 2, share(alpha, n, mu_0));
        Finish { alpha, n, mu_0, polish }
    }

    /// The weight of the middle node of an odd rule.
    pub(super) const fn middle(&self) -> f64 {
        middle(self.alpha, self.n / 2, self.mu_0)
    }

    /// Writes the nodes near the positive floats `x`, and their weights, from place `i` on, as far as there
    /// are places.
    pub(super) const fn write(&self, x: &Lane, i: usize, nodes: &mut [f64], weights: &mut [f64]) {
        let (x, w) = refine(&self.polish, self.n % 2 == 1, x);
        let mut l = 0;
        while l < LANES && i + l < nodes.len() {
            (nodes[i + l], weights[i + l]) = (x[l], w[l]);
            l += 1;
        }
    }
}

/// Sum of the weights of the rule in z, which are those of the positive nodes, times x² for odd n: μ₀/2 for
/// even n, μ₀/(2 (2α + 3)) for odd n.
const fn share(alpha: f64, n: usize, mu_0: Double) -> Double {
    if n % 2 == 1 { mu_0.div(Double::sum(2.0 * alpha, 3.0)).scale(0.5) } else { mu_0.scale(0.5) }
}

/// Floats near positive roots → the rounded roots and their weights.
const fn refine(polish: &Polish, odd: bool, x: &Lane) -> (Lane, Lane) {
    let mut z = Doubles::ZERO;
    let mut l = 0;
    while l < LANES {
        z.set(l, Double::product(2.0 * x[l], x[l]).sub(Double::ONE));
        l += 1;
    }
    let refined = polish.refine(&z);
    let (mut nodes, mut weights) = ([0.0; LANES], refined.weight.hi);
    let mut l = 0;
    while l < LANES {
        nodes[l] = x[l] + root_shift(x[l], refined.shift[l]);
        l += 1;
    }
    let mut l = 0;
    while odd && l < LANES {
        let square = Double::product(x[l], x[l]).add(Double::new(0.5 * refined.shift[l]));
        weights[l] = refined.weight.get(l).div(square).hi;
        l += 1;
    }
    (nodes, weights)
}

/// √(x² + h/2) − x to third order in h.
#[inline(always)]
pub(super) const fn root_shift(x: f64, h: f64) -> f64 {
    let e = 0.25 * h / x;
    e * (1.0 - 0.5 * e / x * (1.0 - e / x))
}

/// The weight of the middle node of 2m + 1 points.
const fn middle(alpha: f64, m: usize, mu_0: Double) -> f64 {
    let mut product = mu_0;
    let mut j = 1;
    while j <= m {
        let whole = Double::sum(j as f64, alpha);
        let above = whole.mul(Double::new(j as f64));
        let below = whole.add(Double::new(0.5)).mul(Double::new(j as f64 + 0.5));
        product = product.mul(above).div(below);
        j += 1;
    }
    product.hi
}
