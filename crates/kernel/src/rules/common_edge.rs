//! Two patches with a common edge: regularising coordinates on six subdomains.
//!
//! The edge is t = 0 in the receiver's chart and v = 0 in the emitter's; s and u run along it in the same
//! sense. With z = |u − s| the kernel κ is homogeneous of degree −2 in (t, v, z). The six subdomains are the
//! two signs of u − s with each of
//!
//! ```text
//! t = x,  v = xa, z = xb        t = xa, v = x,  z = xb        t = xa, v = xb, z = x
//! base = (1 − z) y ,   (s, u) = (base, base + z) or (base + z, base) ,   dV = x² (1 − z) dx dy da db
//! ```
//!
//! x, y, a, b ∈ [0, 1]; x²κ is analytic there. For two parallelograms it depends on neither x nor y: n_x and
//! n_y are those of the exact rule for the polynomials, and n_a alone decides the accuracy:
//!
//! ```text
//! n_a = ⌈ N/2 + ln(1/(cε)) / (2 ln ϱ) ⌉ ,  ϱ = σ + √(σ² − 1) ,  c = min(1, 7.5 (1 − cos φ)) ,
//! ```
//!
//! where φ is the dihedral angle. With the edge length l, the depths h_P and h_Q and h = max(h_P, h_Q), σ is
//! the least of
//!
//! * 1 + 2 sin(φ/2),
//! * q + √(1 + q²), q = min(l/h, h/l), unless l = h,
//! * q + √(1 + q² − 2q cos φ), q = smaller/larger depth, unless they are equal.
//!
//! Patches that are no parallelograms take more points in x and y: n = n_exact + 1 + ⌈log₁₀(1/ε)/1.5⌉.
//!
//! Reference: Sauter and Schwab, *Boundary Element Methods*, chapter 5; also `docs/theory/transport.md`, §5
//! and §6.

pub(crate) mod sum;
pub(crate) mod triangles;
pub(crate) mod parallelograms;
pub(crate) mod table;
pub mod unequal_speed;

use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;
use radiosity_work::interruption::check_interrupt;

use crate::moments::Moments;
use crate::moments::integrand::{Sees, visible_kernel};
use crate::rules::common_edge::parallelograms::ParallelogramPair;
use crate::rules::common_edge::sum::EdgeSum;
use crate::rules::common_edge::table::EdgeTable;
use crate::rules::far;
use crate::tolerances::SMALLEST_SIGMA_OF_EDGE;

/// Largest ratio among edge and depths, those of curved patches at their narrower ends, for which the rule is
/// used; beyond it the pair is split. At 2.5 a point gives 2 log₁₀ ϱ = 0.8 digits, on equal extents at a
/// right angle 1.3. With a larger value more points are needed, with a smaller one more pairs.
pub const LARGEST_ASPECT: f64 = 2.5;

/// Shape of a pair with a common edge.
#[derive(Clone, Copy, Debug)]
pub struct EdgePair {
    /// Length of the common edge.
    pub length: f64,
    /// Extents of receiver and emitter across the edge.
    pub depths: [f64; 2],
    /// The least of them at an end of the edge.
    pub narrowest: f64,
    /// Cosine of the dihedral angle.
    pub cosine: f64,
}

impl EdgePair {
    /// The shape of two patches oriented with the common edge at t = 0.
    pub fn of(p: &Patch, q: &Patch) -> Self {
        let [along, depth_p] = p.extents();
        let depths = [depth_p, q.extents()[1]];
        // The direction away from the edge, by a difference quotient.
        let inward = |patch: &Patch| patch.node(0.5, 1e-3).position - patch.node(0.5, 0.0).position;
        let edge = (p.node(1.0, 0.0).position - p.node(0.0, 0.0).position).normalize();
        let upright = |v: DVec3| (v - edge * v.dot(edge)).normalize_or_zero();
        let length = p.node(0.0, 0.0).position.distance(p.node(1.0, 0.0).position).min(along);
        let narrowest = p.narrowest()[1].min(q.narrowest()[1]);
        Self {
            length,
            depths,
            narrowest,
            cosine: upright(inward(p)).dot(upright(inward(q))).clamp(-1.0, 1.0),
        }
    }

    /// Largest over smallest of edge and depths.
    pub fn aspect(&self) -> f64 {
        let [first, second] = self.depths;
        self.length.max(first).max(second) / self.length.min(self.narrowest)
    }

    /// Convergence rate ϱ in the angular variables a and b; σ is kept above 1 so that ln ϱ > 0.
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
        let sigma = by_angle.min(by_side).min(by_depth).max(SMALLEST_SIGMA_OF_EDGE);
        sigma + (sigma * sigma - 1.0).sqrt()
    }
}

/// Numbers of points [x, y, angular] for degrees `[receiver, emitter]`.
pub fn counts(p: &Patch, q: &Patch, pair: &EdgePair, degrees: [usize; 2], eps: f64) -> [usize; 3] {
    let affine = p.is_parallelogram() && q.is_parallelogram();
    // A chart that is not affine varies along x and y too. On triangles 4 points more were enough, on curved
    // sheets 0, 2 and 4 for ε = 1e-2, 1e-4 and 1e-8; 1 + ⌈log₁₀(1/ε)/1.5⌉ gives 3, 4 and 7.
    let exact = far::exact(degrees);
    let extra = if affine { 0 } else { 1 + (-eps.log10() / 1.5).ceil() as usize };
    // The kernel's peak grows as the angle closes: below 30° σ alone asks for too few points.
    // 7.5 = 1/(1 − cos 30°), so that the factor is 1 from 30° on. The floor, reached at 0.003°, keeps ε above
    // zero.
    let peak = (7.5 * (1.0 - pair.cosine)).clamp(1e-8, 1.0);
    let angular = far::points(degrees[0].max(degrees[1]), eps * peak, pair.rate());
    [exact + extra, exact + extra, angular]
}

/// Adds two flat patches that see each other wholly, oriented with their common edge at t = 0, at any angle
/// and of any proportions.
///
/// Two parallelograms go by `ParallelogramPair`. Other patches are cut in triangles: the two at the edge go
/// by `triangles`, and the pairs of all others, which meet the edge in a corner at most, are returned for the
/// caller to integrate. Returns None, and adds nothing, where the kernel is too nearly singular.
pub fn integrate_flat(
    moments: &mut Moments,
    p: &Patch,
    q: &Patch,
    degrees: [usize; 2],
    eps: f64,
) -> Option<Vec<[Patch; 2]>> {
    if p.is_parallelogram() && q.is_parallelogram() {
        let table = EdgeTable::of(degrees);
        let (angular, samples) = ParallelogramPair::new(p, q).moments(degrees, eps)?;
        moments.own(p, q, &table.moments(&angular));
        moments.samples += samples * table.points() as u64;
        moments.distinct += samples;
        return Some(Vec::new());
    }
    let ([at_p, beyond_p], [at_q, beyond_q]) = (triangles(p), triangles(q));
    if let (Some(a), Some(b)) = (&at_p, &at_q)
        && !triangles::integrate(moments, &doubled(a), &doubled(b), degrees, eps)
    {
        return None;
    }
    let rest = [(&beyond_p, &at_q), (&at_p, &beyond_q), (&beyond_p, &beyond_q)];
    Some(rest.into_iter().filter_map(|(a, b)| Some([a.clone()?, b.clone()?])).collect())
}

/// Cuts a flat patch with its edge at t = 0 by the shorter diagonal: the triangle at that edge, and the other
/// one.
fn triangles(patch: &Patch) -> [Option<Patch>; 2] {
    let (polygon, Patch::Flat { normal, .. }) = (patch.polygon(), patch) else { return [None, None] };
    let triangle = |[a, b, c]: [usize; 3]| {
        let corners = [polygon[a], polygon[b], polygon[c], polygon[c]];
        Some(Patch::Flat { corners, normal: *normal })
    };
    if polygon.len() == 3 {
        return [triangle([0, 1, 2]), None];
    }
    if polygon[0].distance(polygon[2]) <= polygon[1].distance(polygon[3]) {
        [triangle([0, 1, 2]), triangle([0, 2, 3])]
    } else {
        [triangle([0, 1, 3]), triangle([1, 2, 3])]
    }
}

/// The parallelogram whose half s + t ≤ 1 is the triangle.
fn doubled(triangle: &Patch) -> Patch {
    let (Patch::Flat { corners: [a, b, c, _], normal }, ..) = (triangle,) else { return triangle.clone() };
    Patch::Flat { corners: [*a, *b, b + (c - a), *c], normal: *normal }
}

/// Adds two patches oriented with their common edge at t = 0, point by point. The variable t changes in the
/// outermost loops only: for fixed t and v, the sums over y, over the two signs and (in the first two
/// subdomains) over b involve the polynomials along the edge alone.
///
/// ```text
/// S_ij = Σ κ p_i(s) p_j(u) ,   Q_il = Σ p_β(v) S_ij ,   M_kl = Σ p_α(t) Q_il ,   k = (i, α), l = (j, β)
/// ```
pub fn integrate(moments: &mut Moments, p: &Patch, q: &Patch, points: [usize; 3], sees: Option<Sees>) {
    let [radial, along, angular] = points.map(UnitRule::of);
    let mut sum = EdgeSum::new(moments.patches(p, q));
    let slide = |sum: &mut EdgeSum, t: f64, v: f64, z: f64, weight: f64| {
        slide(sum, along, [t, v, z], weight, sees);
    };
    for (x, wx) in radial.iter() {
        // t = x, v = xa, z = xb.
        for (a, wa) in angular.iter() {
            check_interrupt();
            for (b, wb) in angular.iter() {
                slide(&mut sum, x, x * a, x * b, x * x * wx * wa * wb);
            }
            sum.close_across_emitter(x * a);
        }
        sum.close_across_receiver(x);
        for (a, wa) in angular.iter() {
            check_interrupt();
            // t = xa, v = x, z = xb.
            for (b, wb) in angular.iter() {
                slide(&mut sum, x * a, x, x * b, x * x * wx * wa * wb);
            }
            sum.close_across_emitter(x);
            // t = xa, v = xb, z = x.
            for (b, wb) in angular.iter() {
                slide(&mut sum, x * a, x * b, x, x * x * wx * wa * wb);
                sum.close_across_emitter(x * b);
            }
            sum.close_across_receiver(x * a);
        }
    }
    moments.add(sum.pair);
}

/// Adds to S the points of all y and of both signs of u − s.
fn slide(sum: &mut EdgeSum, along: &UnitRule, [t, v, z]: [f64; 3], weight: f64, sees: Option<Sees>) {
    for (y, wy) in along.iter() {
        let base = (1.0 - z) * y;
        for (s, u) in [(base, base + z), (base + z, base)] {
            let [p, q] = sum.pair.patches;
            let (x, y) = (p.node(s, t), q.node(u, v));
            let value = visible_kernel(&x, &y, sees, &mut sum.pair.rays) * x.area * y.area;
            sum.pair.samples += 1;
            if value != 0.0 {
                sum.add(s, u, weight * wy * (1.0 - z) * value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use radiosity_elements::basis::{AreaBasis, Frame};

    use super::*;

    /// A skew pair: the table, which uses that the kernel is homogeneous, and the plain sum agree.
    #[test]
    fn table_and_plain_sum_are_the_same_rule() {
        let edge = DVec3::new(1.0, 0.2, 0.0);
        let flat = |depth: DVec3| {
            let corners = [DVec3::ZERO, edge, edge + depth, depth];
            Patch::Flat { corners, normal: edge.cross(depth).normalize() }
        };
        let p = flat(DVec3::new(0.3, 0.9, 0.0));
        // The front of the second faces the first.
        let Patch::Flat { corners, normal } = flat(DVec3::new(-0.2, 0.1, 1.1)) else { unreachable!() };
        let q = Patch::Flat { corners, normal: -normal };
        let basis = |patch: &Patch, order| {
            // A frame askew to the patch, so that the change of polynomials is not trivial.
            let [a, b, _, d] = patch.corners();
            let frame = Frame::bounding(&patch.corners(), [b - a, 0.2 * (b - a) + (d - a)]);
            AreaBasis::new(order, frame, std::slice::from_ref(patch)).expect("it has area")
        };
        let (receiver, emitter) = (basis(&p, 3), basis(&q, 5));
        let pair = EdgePair::of(&p, &q);
        let points = counts(&p, &q, &pair, [3, 5], 1e-14);
        let mut fast = Moments::new(&receiver, &emitter);
        assert!(integrate_flat(&mut fast, &p, &q, [3, 5], 1e-14).is_some_and(|rest| rest.is_empty()));
        let mut summed = Moments::new(&receiver, &emitter);
        integrate(&mut summed, &p, &q, points, None);
        assert!(fast.distinct < summed.distinct / 10);
        let (fast, summed) = (fast.into_block(), summed.into_block());
        assert!(summed[0] > 0.01, "they exchange light");
        for (a, b) in fast.iter().zip(&summed) {
            assert!((a - b).abs() < 1e-12 * summed[0], "{a} {b}");
        }
    }
}
