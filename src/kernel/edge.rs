//! Patches with a common edge: six regularised subdomains.
//!
//! Both charts have the edge at zero: t = 0 on the receiver, v = 0 on the emitter, s and u running the
//! same way along it. With z = |u − s| the kernel is homogeneous of degree −2 in (t, v, z). For each
//! sign of u − s and each of
//!
//! ```text
//! t = x,  v = xa, z = xb        t = xa, v = x,  z = xb        t = xa, v = xb, z = x
//! base = (1 − z) y ,   (s, u) = (base, base + z) or (base + z, base) ,   dV = x² (1 − z) dx dy da db
//! ```
//!
//! with x, y, a, b ∈ [0, 1], x²κ is analytic. For two parallelograms it does not depend on x or y at
//! all: n_x = n_y = the exact rule of the polynomials, and only n_a carries the accuracy,
//!
//! ```text
//! n_a = ⌈ N/2 + ln(1/ε) / (2 ln ϱ) ⌉ ,  ϱ = σ + √(σ² − 1)
//! ```
//!
//! with dihedral angle φ, and for edge length l and depths h_P, h_Q with h the larger, σ is the least of
//!
//! * 1 + 2 sin(φ/2),
//! * q + √(1 + q²), q = min(l/h, h/l), unless l = h,
//! * q + √(1 + q² − 2q cos φ), q = smaller over larger depth, unless they are equal.

use radiosity_geom::DVec3;

use crate::elements::patch::Patch;
use crate::elements::rule::UnitRule;

use super::edge_table::EdgeTable;
use super::moments::{Moments, Sees};
use super::separated;

/// Largest ratio of edge and depths for which the rule is used; beyond it the pair is split.
pub(super) const LARGEST_ASPECT: f64 = 2.5;

/// Most angular points for which the table of polynomials is kept; it grows with their square.
const LARGEST_TABLE: usize = 24;

/// Shape of a pair with a common edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wedge {
    /// Length of the common edge.
    pub length: f64,
    /// Depths of receiver and emitter away from it.
    pub depths: [f64; 2],
    /// Cosine of the dihedral angle.
    pub cosine: f64,
}

impl Wedge {
    /// Of two patches oriented with the common edge at t = 0.
    pub(super) fn of(p: &Patch, q: &Patch) -> Self {
        let [along, depth_p] = p.extents();
        let depths = [depth_p, q.extents()[1]];
        let inward = |patch: &Patch| patch.node(0.5, 1e-3).position - patch.node(0.5, 0.0).position;
        let edge = (p.node(1.0, 0.0).position - p.node(0.0, 0.0).position).normalize();
        let upright = |v: DVec3| (v - edge * v.dot(edge)).normalize_or_zero();
        let length = p.node(0.0, 0.0).position.distance(p.node(1.0, 0.0).position).min(along);
        Self { length, depths, cosine: upright(inward(p)).dot(upright(inward(q))).clamp(-1.0, 1.0) }
    }

    /// Ratio of the largest to the smallest of edge and depths.
    pub(super) fn aspect(&self) -> f64 {
        let all = [self.length, self.depths[0], self.depths[1]];
        all.iter().copied().fold(0.0, f64::max) / all.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// ϱ of the angular variables.
    fn rate(&self) -> f64 {
        let deeper = self.depths[0].max(self.depths[1]);
        let by_angle = 1.0 + 2.0 * (0.5 * (1.0 - self.cosine)).sqrt();
        let side = (self.length / deeper).min(deeper / self.length);
        let by_side = if side < 1.0 { side + (1.0 + side * side).sqrt() } else { f64::INFINITY };
        let depth = self.depths[0].min(self.depths[1]) / deeper;
        let by_depth = if depth < 1.0 {
            depth + (1.0 + depth * depth - 2.0 * depth * self.cosine).sqrt()
        } else {
            f64::INFINITY
        };
        let sigma = by_angle.min(by_side).min(by_depth).max(1.0 + 1e-6);
        sigma + (sigma * sigma - 1.0).sqrt()
    }
}

/// Numbers of points [x, y, angular] for degrees `[receiver, emitter]`.
pub(super) fn counts(p: &Patch, q: &Patch, wedge: &Wedge, degrees: [usize; 2], eps: f64) -> [usize; 3] {
    let affine = p.is_parallelogram() && q.is_parallelogram();
    // Exact for degree N_i + N_j + 1 where the chart is affine; else x and y see the chart as well.
    let exact = (degrees[0] + degrees[1] + 3) / 2;
    let extra = if affine { 0 } else { 1 + (-eps.log10() / 1.5).ceil() as usize };
    // Below 30° the formula falls short: the kernel's peak grows as the angle closes.
    let peak = (7.5 * (1.0 - wedge.cosine)).clamp(1e-8, 1.0);
    let angular = separated::points(degrees[0].max(degrees[1]), eps * peak, wedge.rate());
    [exact + extra, exact + extra, angular]
}

/// Adds the pair of patches oriented with their common edge at t = 0.
///
/// Two parallelograms that see each other freely go by the table of their polynomials.
pub(super) fn integrate(
    moments: &mut Moments,
    p: &Patch,
    q: &Patch,
    degrees: [usize; 2],
    points: [usize; 3],
    sees: Option<Sees>,
) {
    if sees.is_none() && points[2] <= LARGEST_TABLE && p.is_parallelogram() && q.is_parallelogram() {
        let table = EdgeTable::of(degrees, points[2]);
        moments.own(p, q, &table.moments(p, q));
        moments.samples += table.samples() * (points[0] * points[1]) as u64;
        moments.distinct += table.samples();
        return;
    }
    scattered(moments, p, q, points, sees);
}

/// The plain sum.
pub(super) fn scattered(moments: &mut Moments, p: &Patch, q: &Patch, points: [usize; 3], sees: Option<Sees>) {
    let rules = points.map(UnitRule::of);
    for (x, wx) in rules[0].iter() {
        for (a, wa) in rules[2].iter() {
            for (b, wb) in rules[2].iter() {
                for (t, v, z) in [(x, x * a, x * b), (x * a, x, x * b), (x * a, x * b, x)] {
                    let weight = wx * wa * wb * x * x * (1.0 - z);
                    for (y, wy) in rules[1].iter() {
                        let base = (1.0 - z) * y;
                        for (s, u) in [(base, base + z), (base + z, base)] {
                            moments.scattered(&p.node(s, t), &q.node(u, v), weight * wy, sees);
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::elements::basis::{AreaBasis, Frame};
    /// A skew wedge: the table, which knows that the kernel is homogeneous, against the plain sum.
    #[test]
    fn table_and_plain_sum_are_the_same_rule() {
        let edge = DVec3::new(1.0, 0.2, 0.0);
        let flat = |depth: DVec3| {
            let corners = [DVec3::ZERO, edge, edge + depth, depth];
            Patch::Flat { corners, normal: edge.cross(depth).normalize() }
        };
        let p = flat(DVec3::new(0.3, 0.9, 0.0));
        // The front of the second is turned to the first.
        let Patch::Flat { corners, normal } = flat(DVec3::new(-0.2, 0.1, 1.1)) else { unreachable!() };
        let q = Patch::Flat { corners, normal: -normal };
        let basis = |patch: &Patch, order| {
            // A frame askew to the patch, so that the change of polynomials has work to do.
            let [a, b, _, d] = patch.corners();
            let frame = Frame::bounding(&patch.corners(), [b - a, 0.2 * (b - a) + (d - a)]);
            AreaBasis::new(order, frame, std::slice::from_ref(patch)).expect("it has area")
        };
        let (receiver, emitter) = (basis(&p, 3), basis(&q, 5));
        let wedge = Wedge::of(&p, &q);
        let points = counts(&p, &q, &wedge, [3, 5], 1e-3);
        let mut fast = Moments::new(&receiver, &emitter);
        integrate(&mut fast, &p, &q, [3, 5], points, None);
        let mut plain = Moments::new(&receiver, &emitter);
        scattered(&mut plain, &p, &q, points, None);
        assert_eq!(fast.samples, plain.samples);
        assert!(fast.distinct < plain.distinct / 10);
        let (fast, plain) = (fast.into_block(), plain.into_block());
        assert!(plain[0] > 0.01, "they exchange light");
        for (a, b) in fast.iter().zip(&plain) {
            assert!((a - b).abs() < 1e-12 * plain[0], "{a} {b}");
        }
    }
}
