//! Rules of symmetric weights (1 − x²)^α at half the degree.
//!
//! With z = 2x² − 1 the polynomials of even and odd degree are Jacobi polynomials of half the degree,
//!
//!   π_{2m}(x) ∝ P_m^(α,−½)(z),   π_{2m+1}(x) ∝ x P_m^(α,½)(z),
//!
//! so that a rule of n points costs a recurrence of ⌊n/2⌋ steps at ⌊n/2⌋ points. If ζ is a root, of weight ω in the
//! m-point rule of (α, ∓½) scaled to sum 1, the nodes are ±√((1 + ζ)/2) and, μ₀ being the integral of (1 − x²)^α,
//!
//!   n = 2m:      w = μ₀ ω / 2
//!   n = 2m + 1:  w = μ₀ ω / (4 (α + 3/2) x²),   in the middle  w₀ = μ₀ Π_{j=1…m} j (j + α) / ((j + ½)(j + α + ½))
//!
//! x² W has the integral μ₀/(2α + 3), which explains the factor of the odd case.
//!
//! Reference: G. Szegő, Orthogonal Polynomials, §4.1.

use super::polish::{LANES, Lane, Polish};
use crate::double::Double;
use crate::jacobi::{Weight, monic::Monic};

/// The positive half of a symmetric rule.
pub(super) struct Symmetric {
    polish: Polish,
    odd: bool,
}

impl Symmetric {
    /// For n ≥ 2 points and the weight (1 − x²)^α of integral `mu_0`.
    pub(super) const fn new(alpha: f64, n: usize, mu_0: Double) -> Symmetric {
        let odd = n % 2 == 1;
        let share = if odd {
            mu_0.div(Double::new(2.0).mul(Double::sum(2.0 * alpha, 3.0)))
        } else {
            mu_0.scale(0.5)
        };
        Symmetric { polish: Polish::new(Self::monic(alpha, n), n / 2, share), odd }
    }

    /// The recurrence of P_m^(α,∓½).
    pub(super) const fn monic(alpha: f64, n: usize) -> Monic {
        Monic::new(Weight::valid(alpha, if n % 2 == 1 { 0.5 } else { -0.5 }))
    }

    /// Floats near positive roots → the rounded roots and their weights.
    pub(super) const fn refine(&self, x: &Lane) -> (Lane, Lane) {
        let mut z = [Double::ZERO; LANES];
        let mut l = 0;
        while l < LANES {
            z[l] = Double::product(2.0 * x[l], x[l]).sub(Double::ONE);
            l += 1;
        }
        let refined = self.polish.refine(&z);
        let (mut nodes, mut weights) = ([0.0; LANES], [0.0; LANES]);
        let mut l = 0;
        while l < LANES {
            let shift = refined.shift[l];
            nodes[l] = x[l] + root_shift(x[l], shift);
            weights[l] = if self.odd {
                let square = Double::product(x[l], x[l]).add(Double::new(0.5 * shift));
                refined.weight[l].div(square).hi
            } else {
                refined.weight[l].hi
            };
            l += 1;
        }
        (nodes, weights)
    }
}

/// √(x² + h/2) − x to third order in h.
#[inline(always)]
pub(super) const fn root_shift(x: f64, h: f64) -> f64 {
    let e = 0.25 * h / x;
    e * (1.0 - 0.5 * e / x * (1.0 - e / x))
}

/// The weight of the middle node of 2m + 1 points.
pub(super) const fn middle(alpha: f64, m: usize, mu_0: Double) -> f64 {
    let mut product = mu_0;
    let mut j = 1;
    while j <= m {
        let (j_0, j_a) = (j as f64, Double::sum(j as f64, alpha));
        let above = j_a.mul(Double::new(j_0));
        let below = j_a.add(Double::new(0.5)).mul(Double::new(j_0 + 0.5));
        product = product.mul(above).div(below);
        j += 1;
    }
    product.hi
}
