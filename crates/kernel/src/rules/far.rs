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
//! A rule errs by (64/15) M ϱ⁻²ⁿ/(1 − ϱ⁻²) with the bound M of the kernel in the ellipse, about 1/(π d²) at the
//! distance d of the patches, while the kernel itself is cos θ cos θ′/(π d²): relative to the integral over patches
//! that see each other at a slant, ε is to be smaller by [`slant`].
//!
//! Reference: L. N. Trefethen, *Approximation Theory and Approximation Practice*, chapter 19 (ϱ⁻²ⁿ).

use radiosity_elements::patch::{Node, Patch};

use crate::tolerances::SHARE_OF_ASKEW;

/// Smallest gap/extent for which the rule is used. Measured on parallel unit squares at distance 0.3 for
/// ε = 1e-4: splitting up to ¼ takes 1.5e4 samples, up to ½ and 1 it takes 3.8e4 and 1.5e5.
pub const SMALLEST_RATIO: f64 = 0.25;

/// The constant of the bound of the error of a Gauss rule (Trefethen, theorem 19.3).
const OF_BOUND: f64 = 64.0 / 15.0;

/// Least cos θ cos θ′ that counts: middles of patches that see each other in part may lie behind each other. Chosen.
const LEAST_COSINES: f64 = 0.01;

/// Points for degree `degree` and accuracy `eps` in a direction of convergence rate ϱ (error like ϱ⁻²ⁿ).
pub fn points(degree: usize, eps: f64, rho: f64) -> usize {
    let count = 0.5 * degree as f64 - eps.ln() / (2.0 * rho.ln());
    count.ceil().max(1.0) as usize
}

/// Part of an accuracy that is left relative to the kernel between two patches, cos θ cos θ′ at their middles over the
/// constant of the bound: from 0.0023 to 0.23.
pub fn slant(p: &Patch, q: &Patch) -> f64 {
    let [a, b] = [p, q].map(|patch| patch.node(0.5, 0.5));
    let way = (b.position - a.position).normalize_or_zero();
    let cosine = |from: &Node, way| from.normal.dot(way).max(0.0);
    (cosine(&a, way) * cosine(&b, -way)).max(LEAST_COSINES) / OF_BOUND
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
    use radiosity_elements::rule::UnitRule;
    use radiosity_geom::DVec3;

    use super::*;
    use crate::kernel;

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

    /// A square of side `side` about a place, whose normal makes the angle `turn` with z, on the side of `azimuth`.
    fn turned_square(middle: DVec3, side: f64, turn: f64, azimuth: f64) -> Patch {
        let out = DVec3::new(azimuth.cos(), azimuth.sin(), 0.0);
        let [along, across] = [out * turn.cos() - DVec3::Z * turn.sin(), DVec3::Z.cross(out)];
        let corner = |[a, b]: [f64; 2]| middle + 0.5 * side * (a * along + b * across);
        let corners = [[-1., -1.], [1., -1.], [1., 1.], [-1., 1.]].map(corner);
        Patch::Flat { corners, normal: along.cross(across) }
    }

    /// Kernel between two patches by tensor rules of so many points.
    fn exchange(p: &Patch, q: &Patch, points: [usize; 4]) -> f64 {
        let nodes = |patch: &Patch, [m, n]: [usize; 2]| {
            let [over, along] = [m, n].map(UnitRule::of);
            let places = over.iter().flat_map(|s| along.iter().map(move |t| (s, t)));
            places.map(|((s, ws), (t, wt))| (patch.node(s, t), ws * wt)).collect::<Vec<_>>()
        };
        let [a, b, c, d] = points;
        let (ours, theirs) = (nodes(p, [a, b]), nodes(q, [c, d]));
        let pairs = ours.iter().flat_map(|x| theirs.iter().map(move |y| (x, y)));
        pairs.map(|((x, v), (y, w))| v * w * x.area * y.area * kernel(x, y)).sum()
    }

    /// Squares above each other that are turned until they see each other at a slant: their factors keep the accuracy
    /// with [`slant`], and miss it without, in a tenth of them by twice and more.
    #[test]
    fn factors_at_a_slant_are_as_accurate_as_asked() {
        const EPS: f64 = 1e-3;
        let angles = [0.0, 0.5, 1.0, 1.3, 1.38];
        let (mut off, mut off_without): (Vec<f64>, Vec<f64>) = Default::default();
        for (ours, theirs) in angles.iter().flat_map(|a| angles.iter().map(move |b| (*a, *b))) {
            for (azimuth, distance) in [(0.0, 1.0), (0.7, 1.6), (2.1, 2.5), (3.1, 4.0)] {
                let p = turned_square(DVec3::ZERO, 0.3, ours, 0.3);
                let q = turned_square(DVec3::Z * distance, 0.3, std::f64::consts::PI - theirs, azimuth);
                let right = exchange(&p, &q, [12; 4]);
                let gap = distance - 0.15 * (ours.sin() + theirs.sin());
                let error = |eps| (exchange(&p, &q, counts(&p, &q, [0; 2], gap, eps)) / right - 1.0).abs();
                off.push(error(slant(&p, &q) * EPS));
                off_without.push(error(EPS));
            }
        }
        let missed = |errors: &[f64], by: f64| errors.iter().filter(|error| **error > by * EPS).count();
        assert_eq!(missed(&off, 1.0), 0, "{off:?}");
        assert!(missed(&off_without, 2.0) > off.len() / 10, "{off_without:?}");
    }
}
