//! Patches with one common corner: four regularised subdomains.
//!
//! Both charts have the corner at the origin. In each of
//!
//! ```text
//! (s, t, u, v) = x · (1, a, b, c)  and the other three places of the 1 ,    dV = x³ dx da db dc
//! ```
//!
//! x²κ is analytic, and for two parallelograms it does not depend on x. The angular count follows the
//! common edge's formula with ϱ ≤ 4.2.

use crate::elements::patch::Patch;
use crate::elements::rule::UnitRule;

use super::integrand::Sees;
use super::moments::Moments;
use super::product::Line;
use super::separated;

/// Numbers of points [x, angular] for degrees `[receiver, emitter]`.
pub(super) fn counts(p: &Patch, q: &Patch, degrees: [usize; 2], eps: f64) -> [usize; 2] {
    let affine = p.is_parallelogram() && q.is_parallelogram();
    let exact = (degrees[0] + degrees[1] + 3) / 2;
    let extra = if affine { 0 } else { 1 + (-eps.log10() / 1.5).ceil() as usize };
    let ratio = 1.0 / aspect(p, q);
    let sigma = ratio + (1.0 + ratio * ratio).sqrt();
    let rho = (sigma + (sigma * sigma - 1.0).sqrt()).min(4.2);
    [exact + extra, separated::points(degrees[0].max(degrees[1]), eps, rho)]
}

/// Ratio of the largest to the smallest extent of the two patches.
pub(super) fn aspect(p: &Patch, q: &Patch) -> f64 {
    let extents = [p.extents(), q.extents()].concat();
    extents.iter().copied().fold(0.0, f64::max) / extents.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Adds the pair of patches oriented with their common corner at (0, 0).
///
/// For each x the four subdomains are tensor grids: one coordinate stands at x, the others run to it.
pub(super) fn integrate(moments: &mut Moments, p: &Patch, q: &Patch, points: [usize; 2], sees: Option<Sees>) {
    let (radial, angular) = (UnitRule::of(points[0]), UnitRule::of(points[1]));
    let mut pair = moments.patches(p, q);
    for (x, wx) in radial.iter() {
        let scaled: Vec<f64> = angular.nodes.iter().map(|a| x * a).collect();
        let (fixed, running): (Line, Line) = ((&[x], &[1.0]), (&scaled, &angular.weights));
        for place in 0..4 {
            let lines = std::array::from_fn(|k| if k == place { fixed } else { running });
            pair.product(lines, wx * x * x * x, sees);
        }
    }
    moments.add(pair);
}
