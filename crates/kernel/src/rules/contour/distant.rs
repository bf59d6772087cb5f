//! Polygons far apart compared with their sizes: a product of Gauss rules in which nothing cancels.
//!
//! Both contours are closed, so that functions of one end alone may be subtracted from ln r. Let p and q be
//! the middles of the polygons, R = |p − q| the unit of length, u = p − q, x and y the points relative to
//! their middles, and
//!
//! ```text
//! ε_x = 2u·x + x² ,   x̂ = x / (1 + ε_x) ,   η_x = ε_x / (1 + ε_x)      (for y with −u),
//! ln r − ln|x − q| − ln|y − p| = ½ ln(1 + z) ,     z = −2 x̂·ŷ − η_x η_y ,
//! ```
//!
//! which is of the size of the result, (size/R)², before it is summed. The contour integral of ln r itself
//! loses the digits of (R/size)². √(1 + z) is the cross ratio of x, y, p and q; by Ptolemy's inequality it
//! differs from 1 by at most
//!
//! ```text
//! k = |x||y| / (|x − q||y − p|) ,
//! ```
//!
//! so that ½ ln(1 + z) = w + w³/3 + w⁵/5 + … with w = z/(2 + z), |w| ≤ k/(1 − k), needs few terms.
//!
//! Along an edge the integrand is analytic, except where the edge's line meets the other polygon in complex
//! points. Of all edges inside a ball of radius ϱ whose centre is at least D from all points of the other
//! polygon, those on the tangent cone converge slowest: like (σ + √(σ² − 1))⁻²ⁿ with σ = √(D² − ϱ²)/ϱ.

use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;

use crate::rules::contour::segment::edges;
use crate::tolerances::{DIGITS_OF_DISTANT, MOST_POINTS_OF_DISTANT, ROUNDING_OF_DIRECTIONS};

/// Largest k: eight terms of the series, with |w| ≤ 1/9, then leave 3e-17.
const LARGEST_CROSS: f64 = 0.1;
/// Points added to the formula: with 0.3 no error above 2e-14 of A_i A_j/R² was found among 20 000 random
/// pairs.
const SURPLUS: f64 = 0.3;
/// Points per step of the inner loop: two fill the narrowest vector registers. Rules have 2 to 14 points, and
/// wider lanes would compute more places that are unused.
const LANES: usize = 2;

/// A ball about a polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    /// Mean of the corners.
    pub center: DVec3,
    /// Largest distance of a corner from it.
    pub radius: f64,
}

impl Ball {
    /// About a polygon with at least one corner.
    pub(super) fn about(polygon: &[DVec3]) -> Self {
        let origin = polygon[0];
        let center = origin + polygon.iter().map(|x| x - origin).sum::<DVec3>() / polygon.len() as f64;
        let radius2 = polygon.iter().map(|x| x.distance_squared(center)).fold(0.0, f64::max);
        Self { center, radius: radius2.sqrt() }
    }
}

/// A polygon with its ball.
#[derive(Clone, Copy)]
pub(super) struct Shape<'a> {
    pub corners: &'a [DVec3],
    pub ball: Ball,
}

/// Points per edge of either polygon, and k.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan {
    points: [usize; 2],
    cross: f64,
}

impl Plan {
    /// None where the polygons are not far enough apart.
    pub(super) fn of(p: &Ball, q: &Ball) -> Option<Self> {
        let distance = p.center.distance(q.center);
        let (clear_p, clear_q) = (distance - p.radius, distance - q.radius);
        let cross = p.radius * q.radius / (clear_p * clear_q);
        if clear_p.min(clear_q) <= 0.0 || cross > LARGEST_CROSS {
            return None;
        }
        Some(Self { points: [points(p.radius, clear_q)?, points(q.radius, clear_p)?], cross })
    }

    /// ∮∮ ln r dx·dy, and the number of logarithms. The first omitted term of the series is below 1e-16 of
    /// each logarithm.
    pub(super) fn integral(&self, p: Shape, q: Shape) -> (f64, u64) {
        match self.cross {
            k if k <= 3e-3 => self.sum::<3>(p, q),
            k if k <= 3e-2 => self.sum::<5>(p, q),
            _ => self.sum::<8>(p, q),
        }
    }

    fn sum<const TERMS: usize>(&self, p: Shape, q: Shape) -> (f64, u64) {
        let between = p.ball.center - q.ball.center;
        let scale = between.length().recip();
        let side_p = Side { center: p.ball.center, scale, towards: between * scale };
        let side_q = Side { center: q.ball.center, scale, towards: -between * scale };
        let [rule_p, rule_q] = self.points.map(UnitRule::of);
        let chunk = rule_q.nodes.len().div_ceil(LANES);
        let mut inner = Vec::with_capacity(chunk * q.corners.len());
        for edge in edges(q.corners) {
            side_q.push_lanes(edge, rule_q, &mut inner);
        }
        let (mut sum, mut pairs) = (0.0, 0);
        for [start, end] in edges(p.corners) {
            let step = end - start;
            let mut outer: Option<[Node; MOST_POINTS_OF_DISTANT]> = None;
            for ([other, other_end], lanes) in edges(q.corners).zip(inner.chunks_exact(chunk)) {
                let other_step = other_end - other;
                let cosine = step.dot(other_step);
                let lengths2 = step.length_squared() * other_step.length_squared();
                if cosine * cosine <= ROUNDING_OF_DIRECTIONS * ROUNDING_OF_DIRECTIONS * lengths2 {
                    continue;
                }
                let nodes = outer.get_or_insert_with(|| side_p.nodes([start, end], rule_p));
                let rows = nodes.iter().zip(&rule_p.weights).map(|(node, w)| w * row::<TERMS>(node, lanes));
                sum += cosine * rows.sum::<f64>();
                pairs += 1;
            }
        }
        (sum, pairs * (self.points[0] * self.points[1]) as u64)
    }
}

/// Points per edge inside a ball, if all of the other polygon is at least `clear` from its middle; None if
/// too many.
fn points(radius: f64, clear: f64) -> Option<usize> {
    if clear <= radius {
        return None;
    }
    let sigma = ((clear - radius) * (clear + radius)).sqrt() / radius;
    if sigma <= 1.0 {
        return None;
    }
    let count =
        (SURPLUS + DIGITS_OF_DISTANT / (2.0 * (sigma + (sigma * sigma - 1.0).sqrt()).ln())).ceil() as usize;
    (count <= MOST_POINTS_OF_DISTANT).then_some(count.max(2))
}

/// The map from a point of one polygon to x̂ and η.
struct Side {
    center: DVec3,
    scale: f64,
    towards: DVec3,
}

/// x̂ and η_x.
#[derive(Clone, Copy, Default)]
struct Node {
    image: DVec3,
    excess: f64,
}

/// 2 x̂, η and weights of a few points; unused places have weight zero.
#[derive(Clone, Copy, Default)]
struct Lanes {
    x: [f64; LANES],
    y: [f64; LANES],
    z: [f64; LANES],
    excess: [f64; LANES],
    weight: [f64; LANES],
}

impl Side {
    /// Start and step of an edge relative to the middle, so that its points are not rounded at the distance
    /// of the origin.
    fn seen(&self, [start, end]: [DVec3; 2]) -> (DVec3, DVec3) {
        ((start - self.center) * self.scale, (end - start) * self.scale)
    }

    fn node(&self, x: DVec3) -> Node {
        let excess = 2.0 * self.towards.dot(x) + x.length_squared();
        let shrink = (1.0 + excess).recip();
        Node { image: x * shrink, excess: excess * shrink }
    }

    /// The points of a rule on an edge.
    fn nodes(&self, edge: [DVec3; 2], rule: &UnitRule) -> [Node; MOST_POINTS_OF_DISTANT] {
        let (start, step) = self.seen(edge);
        let mut nodes = [Node::default(); MOST_POINTS_OF_DISTANT];
        for (node, s) in nodes.iter_mut().zip(&rule.nodes) {
            *node = self.node(start + step * *s);
        }
        nodes
    }

    /// Appends the points of a rule on an edge, in lanes for the inner loop.
    fn push_lanes(&self, edge: [DVec3; 2], rule: &UnitRule, all: &mut Vec<Lanes>) {
        let (start, step) = self.seen(edge);
        for (nodes, weights) in rule.nodes.chunks(LANES).zip(rule.weights.chunks(LANES)) {
            let mut lanes = Lanes::default();
            for (k, (s, w)) in nodes.iter().zip(weights).enumerate() {
                let node = self.node(start + step * *s);
                let image = 2.0 * node.image;
                (lanes.x[k], lanes.y[k], lanes.z[k]) = (image.x, image.y, image.z);
                (lanes.excess[k], lanes.weight[k]) = (node.excess, *w);
            }
            all.push(lanes);
        }
    }
}

/// Σ weight · ½ ln(1 + z).
#[inline]
fn row<const TERMS: usize>(node: &Node, row: &[Lanes]) -> f64 {
    let mut sums = [0.0; LANES];
    let (image, excess) = (node.image, node.excess);
    for lanes in row {
        for (k, sum) in sums.iter_mut().enumerate() {
            let z =
                image.x * lanes.x[k] + image.y * lanes.y[k] + image.z * lanes.z[k] + excess * lanes.excess[k];
            *sum += lanes.weight[k] * half_log::<TERMS>(-z);
        }
    }
    sums.iter().sum()
}

/// ½ ln(1 + z) by TERMS terms of its series in z/(2 + z).
#[inline]
fn half_log<const TERMS: usize>(z: f64) -> f64 {
    const RECIPROCALS: [f64; 8] =
        [1.0, 1.0 / 3.0, 1.0 / 5.0, 1.0 / 7.0, 1.0 / 9.0, 1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0];
    let w = z / (2.0 + z);
    let w2 = w * w;
    let mut sum = 0.0;
    for k in (0..TERMS).rev() {
        sum = sum * w2 + RECIPROCALS[k];
    }
    w * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_is_a_logarithm_to_rounding_within_its_bound() {
        // (1 ± k)² bounds 1 + z.
        let ends = |k: f64| [(1.0 - k).powi(2) - 1.0, (1.0 + k).powi(2) - 1.0, 1e-3 * k];
        for z in ends(3e-3) {
            assert!((half_log::<3>(z) / (0.5 * z.ln_1p()) - 1.0).abs() < 1e-15);
        }
        for z in ends(3e-2) {
            assert!((half_log::<5>(z) / (0.5 * z.ln_1p()) - 1.0).abs() < 1e-15);
        }
        for z in ends(LARGEST_CROSS) {
            assert!((half_log::<8>(z) / (0.5 * z.ln_1p()) - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn near_polygons_have_no_plan() {
        let ball = |x: f64, radius: f64| Ball { center: DVec3::X * x, radius };
        assert!(Plan::of(&ball(0.0, 1.0), &ball(5.0, 1.0)).is_some());
        for (x, radius) in [(3.0, 1.0), (1.5, 1.0), (0.0, 1.0), (1e3, 900.0)] {
            assert!(Plan::of(&ball(0.0, 1.0), &ball(x, radius)).is_none(), "{x} {radius}");
        }
    }
}
