//! Patches apart: a tensor Gauss rule whose number of points is known beforehand.
//!
//! Per direction d of the two charts, with extent h_d, gap g between the patches and r = g/h_d,
//!
//! ```text
//! n_d = ⌈ N/2 + ln(1/ε) / (2 ln ϱ) ⌉ ,     ϱ = 2r + √(4r² + 1)
//! ```
//!
//! where N is the degree of the integrated polynomial along d: the kernel is analytic in an ellipse of
//! sum ϱ about the direction's interval. Measured on parallel squares the count is right to one point
//! for r ≥ ¼; closer pairs are split first.

use crate::elements::patch::Patch;

/// Smallest gap over extent at which the rule is used.
pub(in crate::transport) const SMALLEST_RATIO: f64 = 0.25;

/// What is asked of charts whose directions are not at right angles: measured, the count falls short by a little there.
const ASKEW: f64 = 0.5;

/// Points for degree `degree` and accuracy `eps` in a direction where the convergence is ϱ⁻²ⁿ.
pub(in crate::transport) fn points(degree: usize, eps: f64, rho: f64) -> usize {
    let count = 0.5 * degree as f64 - eps.ln() / (2.0 * rho.ln());
    count.ceil().max(1.0) as usize
}

/// Points exact for degree N_i + N_j + 1: the polynomials of both sides along a line where the kernel is constant.
pub(in crate::transport) fn exact(degrees: [usize; 2]) -> usize {
    (degrees[0] + degrees[1] + 3) / 2
}

/// Points along s and t of the receiver, then of the emitter, for degrees `[receiver, emitter]`.
///
/// `gap` is positive. A chart that is not affine raises the degree by one: its area element is linear.
pub(in crate::transport) fn counts(
    p: &Patch,
    q: &Patch,
    degrees: [usize; 2],
    gap: f64,
    eps: f64,
) -> [usize; 4] {
    let count = |patch: &Patch, degree: usize| {
        let degree = degree + usize::from(!patch.is_parallelogram());
        let eps = if patch.is_rectangle() { eps } else { ASKEW * eps };
        patch.extents().map(|extent| {
            let ratio = gap / extent;
            points(degree, eps, 2.0 * ratio + (4.0 * ratio * ratio + 1.0).sqrt())
        })
    };
    let ([a, b], [c, d]) = (count(p, degrees[0]), count(q, degrees[1]));
    [a, b, c, d]
}

#[cfg(test)]
mod tests {
    use super::*;
    use radiosity_geom::DVec3;

    /// Points per direction of two parallel unit squares, measured: distance, then for ε = 1e-2,
    /// 1e-4, 1e-8 at degree 4 and degree 8.
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
