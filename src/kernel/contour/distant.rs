//! Polygons far apart in relation to their sizes: a product of Gauss rules in which nothing cancels.
//!
//! Both contours are closed, so any function of one end alone may be subtracted from ln r. With the middles p and q
//! of the polygons, R = |p − q| taken as the unit, u = p − q, x and y the ends seen from their middles, and
//!
//! ```text
//! ε_x = 2u·x + x² ,   x̂ = x / (1 + ε_x) ,   η_x = ε_x / (1 + ε_x)      (for y with −u),
//! ln r − ln|x − q| − ln|y − p| = ½ ln(1 + z) ,     z = −2 x̂·ŷ − η_x η_y ,
//! ```
//!
//! which is of the size of the result, (size/R)², before it is summed; the contour integral of ln r itself loses the
//! digits of (R/size)². √(1 + z) is the cross ratio of x, y, p and q. By Ptolemy's inequality it differs from 1
//! by no more than
//!
//! ```text
//! k = |x||y| / (|x − q||y − p|) ,
//! ```
//!
//! so that ½ ln(1 + z) = w + w³/3 + w⁵/5 + …, w = z/(2 + z), |w| ≤ k/(1 − k), needs few terms.
//!
//! Along an edge the integrand is analytic but where the edge's line meets the other polygon in complex points.
//! Of all edges inside a ball of radius ϱ, seen from the distance D of the other ball, those under the tangent cone
//! converge slowest, like (σ + √(σ² − 1))⁻²ⁿ with σ = √(D² − ϱ²)/ϱ.

use radiosity_geom::DVec3;

use crate::elements::rule::UnitRule;

use super::segment::edges;

/// Largest k.
const LARGEST_CROSS: f64 = 0.1;
/// Below this k half as many terms of the logarithm do.
const SMALL_CROSS: f64 = 0.01;
/// ln(1/ε) of the rules.
const DIGITS: f64 = 32.0;
/// Most points per edge.
const MOST: usize = 14;
/// Points per step of the inner loop.
const LANES: usize = 4;
/// Most steps of the inner loop between two changes of the outer point.
const STEPS: usize = 16;
/// Cosines below this are rounding errors of a right angle.
const RIGHT_ANGLE: f64 = 1e-15;

/// A ball about a polygon.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    /// Mean of the corners.
    pub center: DVec3,
    /// Largest distance of a corner from it.
    pub radius: f64,
}

impl Ball {
    /// About a polygon that has corners.
    pub(super) fn about(polygon: &[DVec3]) -> Self {
        let origin = polygon[0];
        let center = origin + polygon.iter().map(|x| x - origin).sum::<DVec3>() / polygon.len() as f64;
        let radius2 = polygon.iter().map(|x| x.distance_squared(center)).fold(0.0, f64::max);
        Self { center, radius: radius2.sqrt() }
    }
}

/// A polygon with its ball.
type Shape<'a> = (&'a [DVec3], Ball);

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

    /// ∮∮ ln r dx·dy, and the number of logarithms it took.
    pub(super) fn integral(&self, p: Shape, q: Shape) -> (f64, u64) {
        if self.cross <= SMALL_CROSS { self.sum::<5>(p, q) } else { self.sum::<9>(p, q) }
    }

    fn sum<const TERMS: usize>(&self, (p, ball_p): Shape, (q, ball_q): Shape) -> (f64, u64) {
        let between = ball_p.center - ball_q.center;
        let scale = between.length().recip();
        let side_p = Side { center: ball_p.center, scale, towards: between * scale };
        let side_q = Side { center: ball_q.center, scale, towards: -between * scale };
        let (rule_p, rule_q) = (UnitRule::of(self.points[0]), UnitRule::of(self.points[1]));
        let (mut sum, mut terms) = (0.0, 0);
        for (start, end) in edges(p) {
            let step = end - start;
            let mut row = Row::new();
            let flush = |row: &mut Row| {
                let outer = rule_p.iter().map(|(s, w)| w * row.sum::<TERMS>(&side_p.node(start + step * s)));
                let (value, count) = (outer.sum::<f64>(), row.count * rule_p.nodes.len());
                *row = Row::new();
                (value, count as u64)
            };
            for (other, other_end) in edges(q) {
                let other_step = other_end - other;
                let cosine = step.dot(other_step);
                if cosine * cosine
                    <= RIGHT_ANGLE * RIGHT_ANGLE * step.length_squared() * other_step.length_squared()
                {
                    continue;
                }
                for (t, w) in rule_q.iter() {
                    row.push(&side_q.node(other + other_step * t), cosine * w);
                    if row.is_full() {
                        let (value, count) = flush(&mut row);
                        (sum, terms) = (sum + value, terms + count);
                    }
                }
            }
            let (value, count) = flush(&mut row);
            (sum, terms) = (sum + value, terms + count);
        }
        (sum, terms)
    }
}

/// Points per edge inside a ball, the other ball being `clear` from its middle; None if too many.
fn points(radius: f64, clear: f64) -> Option<usize> {
    if clear <= radius {
        return None;
    }
    let sigma = ((clear - radius) * (clear + radius)).sqrt() / radius;
    if sigma <= 1.0 {
        return None;
    }
    let count = (DIGITS / (2.0 * (sigma + (sigma * sigma - 1.0).sqrt()).ln())).ceil() as usize;
    (count <= MOST).then_some(count.max(2))
}

/// What turns a point of one polygon into x̂ and η.
struct Side {
    center: DVec3,
    scale: f64,
    towards: DVec3,
}

/// x̂ and η_x.
struct Node {
    image: DVec3,
    excess: f64,
}

impl Side {
    fn node(&self, point: DVec3) -> Node {
        let x = (point - self.center) * self.scale;
        let excess = 2.0 * self.towards.dot(x) + x.length_squared();
        let shrink = (1.0 + excess).recip();
        Node { image: x * shrink, excess: excess * shrink }
    }
}

/// Points of the inner contour, ready for the wide loop; the places of those that lack have the weight zero.
struct Row {
    lanes: [Lanes; STEPS],
    count: usize,
}

/// Twice x̂, η and the weight of a few points.
#[derive(Clone, Copy)]
struct Lanes {
    x: [f64; LANES],
    y: [f64; LANES],
    z: [f64; LANES],
    excess: [f64; LANES],
    weight: [f64; LANES],
}

impl Row {
    fn new() -> Self {
        let zero = [0.0; LANES];
        let empty = Lanes { x: zero, y: zero, z: zero, excess: zero, weight: zero };
        Self { lanes: [empty; STEPS], count: 0 }
    }

    fn is_full(&self) -> bool {
        self.count == LANES * STEPS
    }

    fn push(&mut self, node: &Node, weight: f64) {
        let (lanes, k) = (&mut self.lanes[self.count / LANES], self.count % LANES);
        let image = 2.0 * node.image;
        (lanes.x[k], lanes.y[k], lanes.z[k]) = (image.x, image.y, image.z);
        (lanes.excess[k], lanes.weight[k]) = (node.excess, weight);
        self.count += 1;
    }

    /// Σ weight · ½ ln(1 + z).
    fn sum<const TERMS: usize>(&self, node: &Node) -> f64 {
        let mut sums = [0.0; LANES];
        let (image, excess) = (node.image, node.excess);
        for lanes in &self.lanes[..self.count.div_ceil(LANES)] {
            for k in 0..LANES {
                let z = -(image.x * lanes.x[k]
                    + image.y * lanes.y[k]
                    + image.z * lanes.z[k]
                    + excess * lanes.excess[k]);
                sums[k] += lanes.weight[k] * half_log::<TERMS>(z);
            }
        }
        sums.iter().sum()
    }
}

/// ½ ln(1 + z) by TERMS terms of its series in z/(2 + z).
#[inline]
fn half_log<const TERMS: usize>(z: f64) -> f64 {
    const RECIPROCALS: [f64; 9] =
        [1.0, 1.0 / 3.0, 1.0 / 5.0, 1.0 / 7.0, 1.0 / 9.0, 1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0, 1.0 / 17.0];
    let w = z / (2.0 + z);
    let w2 = w * w;
    let mut sum = 0.0;
    for k in (0..TERMS).rev() {
        sum = sum * w2 + RECIPROCALS[k];
    }
    w * sum
}
