//! Two patches far apart: a tensor Gauss rule whose number of points is known beforehand.
//!
//! In each direction d of either chart, with the extent h_d, the gap g between the patches and r = g/h_d,
//!
//! ```text
//! n_d = ⌈ N/2 + ln(1/ε) / (2 ln ϱ) ⌉ ,     ϱ = 2r + √(4r² + 1) ,     n_d ≥ 1.
//! ```
//!
//! N is the degree of the element's polynomials, plus 1 where the chart is not affine; ε is halved on a chart
//! without right angles. The kernel is analytic in the ellipse with foci at the ends of the interval and the
//! sum of half axes ϱ (in halves of the interval). On parallel unit squares at distances 1, 0.5 and 0.3
//! (N = 4, 8; ε = 1e-2, 1e-4, 1e-8) the formula is within one point of the need. Closer pairs, r < ¼, are
//! split first.
//!
//! Reference: L. N. Trefethen, *Approximation Theory and Approximation Practice*, chapter 19 (ϱ⁻²ⁿ).

use radiosity_elements::patch::Patch;

use crate::tolerances::SHARE_OF_ASKEW;

/// Smallest gap/extent for which the rule is used. Measured on parallel unit squares at distance 0.3 for
/// ε = 1e-4: splitting up to ¼ takes 1.5e4 samples, up to ½ and 1 it takes 3.8e4 and 1.5e5.
pub const SMALLEST_RATIO: f64 = 0.25;

/// Points for degree `degree` and accuracy `eps` in a direction of convergence rate ϱ (error like ϱ⁻²ⁿ).
pub fn points(degree: usize, eps: f64, rho: f64) -> usize {
    let count = 0.5 * degree as f64 - eps.ln() / (2.0 * rho.ln());
    count.ceil().max(1.0) as usize
}

/// Sum of half axes ϱ of the ellipse in which the kernel is analytic, for a gap over an extent.
pub fn rho(ratio: f64) -> f64 {
    2.0 * ratio + (4.0 * ratio * ratio + 1.0).sqrt()
}

/// Largest ratio ϱ⁻² of the errors of two rules of which the second has a point more, over all directions.
pub fn ratio(p: &Patch, q: &Patch, gap: f64) -> f64 {
    let longest = p.longest().1.max(q.longest().1);
    rho(gap / longest).powi(-2)
}

/// Points that integrate degree N_i + N_j + 1 exactly: the product of both sides' polynomials and a linear
/// area element.
pub fn exact(degrees: [usize; 2]) -> usize {
    (degrees[0] + degrees[1] + 3) / 2
}

/// Points along s and t of the receiver, then of the emitter, for degrees `[receiver, emitter]`.
///
/// `gap` is positive. On a chart that is not affine the area element is linear, which adds one to the degree.
pub fn counts(p: &Patch, q: &Patch, degrees: [usize; 2], gap: f64, eps: f64) -> [usize; 4] {
    let count = |patch: &Patch, degree: usize| {
        let degree = degree + usize::from(!patch.is_parallelogram());
        let eps = if patch.is_rectangle() { eps } else { SHARE_OF_ASKEW * eps };
        patch.extents().map(|extent| points(degree, eps, rho(gap / extent)))
    };
    let ([a, b], [c, d]) = (count(p, degrees[0]), count(q, degrees[1]));
    [a, b, c, d]
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;

    use super::*;

    /// Points per direction of two parallel unit squares: distance, then ε = 1e-2, 1e-4, 1e-8 at degree 4 and
    /// degree 8. Each is within one of the number that was measured to suffice.
    #[test]
    fn counts_follow_the_measured_table() {
        let square = |z: f64| Patch::Flat {
            corners: [[0., 0.], [1., 0.], [1., 1.], [0., 1.]].map(|[x, y]| DVec3::new(x, y, z)),
            normal: DVec3::Z,
        };
        let table =
            [(1.0, [4, 6, 9], [6, 8, 11]), (0.5, [5, 8, 13], [7, 10, 15]), (0.3, [7, 11, 19], [9, 13, 21])];
        for (distance, four, eight) in table {
            for (degree, row) in [(4, four), (8, eight)] {
                for (eps, expected) in [1e-2, 1e-4, 1e-8].into_iter().zip(row) {
                    let n = counts(&square(0.0), &square(distance), [degree; 2], distance, eps);
                    assert_eq!(n, [expected; 4], "distance {distance} degree {degree} eps {eps}");
                }
            }
        }
    }
}
