//! A concave patch with itself: relative coordinates that regularise the kernel.
//!
//! Where the two points of a smooth surface meet, the kernel is bounded, but its limit depends on the
//! direction of approach and at the point itself it is 0/0. With z = |u − s| and w = |v − t| in polar form on
//! two triangles,
//!
//! ```text
//! (z, w) = (x, xa)   and   (xa, x) ,     dz dw = x dx da
//! (s, u) = (1 − z) y + (0, z) ,   (t, v) = (1 − w) y' + (0, w) or (w, 0) ,     dV = x (1 − z)(1 − w) dx da dy dy' ,
//! ```
//!
//! it is analytic in x, a, y, y' ∈ [0, 1]. Two of the four signs of (u − s, v − t) follow by exchanging the
//! points: the block is H + Hᵀ, and this rule sums H. The nearest singularity in a is a = ±iq, a complex
//! direction in which both points meet, with q the smallest over the largest side. Hence
//!
//! ```text
//! n_a = ⌈ N/2 + ln(1/ε) / (2 ln ϱ) ⌉ + 1 ,  ϱ = σ + √(σ² − 1) ,  σ = q + √(1 + q²) .
//! ```
//!
//! and n_x = n_y = N + 1 plus the points of the chart. The + 1 is a margin.
//!
//! Reference: Sauter and Schwab, *Boundary Element Methods*, 5.2.1 (identical panels).

use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_work::interruption::check_interrupt;

use crate::moments::Moments;
use crate::moments::integrand::Sees;
use crate::rules::far;

/// Numbers of points [x, a, y] for polynomials of degree `degree` on a patch whose chart adds `chart` points.
pub fn counts(patch: &Patch, degree: usize, chart: usize, eps: f64) -> [usize; 3] {
    let ([along, across], [thin, low]) = (patch.extents(), patch.narrowest());
    let q = thin.min(low) / along.max(across);
    let sigma = q + (1.0 + q * q).sqrt();
    let rho = sigma + (sigma * sigma - 1.0).sqrt();
    [degree + 1 + chart, far::points(degree, eps, rho) + 1, degree + 1 + chart]
}

/// Adds H, half of the moments of a patch with itself; the other half is the transpose.
pub fn integrate(moments: &mut Moments, patch: &Patch, points: [usize; 3], sees: Option<Sees>) {
    let [radial, angular, base] = points.map(UnitRule::of);
    for ((x, wx), (a, wa)) in radial.iter().flat_map(|x| angular.iter().map(move |a| (x, a))) {
        check_interrupt();
        for (z, w) in [(x, x * a), (x * a, x)] {
            let weight = wx * wa * x * (1.0 - z) * (1.0 - w);
            for ((y, wy), (y2, wy2)) in base.iter().flat_map(|y| base.iter().map(move |y2| (y, y2))) {
                let (s, t) = ((1.0 - z) * y, (1.0 - w) * y2);
                for (low, high) in [(t, t + w), (t + w, t)] {
                    moments.scattered(&patch.node(s, low), &patch.node(s + z, high), weight * wy * wy2, sees);
                }
            }
        }
    }
}
