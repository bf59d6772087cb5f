//! A small polygon near a large one.
//!
//! The contour integral of ln r over edges of length L, relative to an area l², loses the digits of L/l. But
//! the small contour is closed, so that any function of the point y of the large one may be subtracted from
//! ln r, another on every stretch of it. With the small polygon in a ball of radius ϱ about the origin,
//!
//! ```text
//! ln r − ln|y| = ½ ln(1 + z) ,     z = (x² − 2x·y) / y² ,
//! ```
//!
//! is of the size l/|y|; a product of Gauss rules sums it on stretches no longer than their distance.
//! Stretches near the ball are cut down to its size and go edge by edge.

use radiosity_elements::rule::UnitRule;
use radiosity_geom::DVec3;

use crate::rules::contour::pair;
use crate::rules::contour::segment::Segment;
use crate::tolerances::{DIGITS_OF_CONTOUR, MOST_POINTS_OF_CONTOUR, SMALLEST_SIGMA_OF_CONTOUR};

/// Least distance, in units of ϱ, of stretches that go by Gauss' rules: there the cone's σ = √8 takes 11
/// points. With a smaller value rules need more points, with a larger one more stretches go edge by edge.
const CLEAR: f64 = 3.0;
/// Largest length, in units of ϱ, of stretches that go edge by edge, by which the digits of its square are
/// lost: one at 4. With a smaller value there are more stretches.
const SHORT: f64 = 4.0;

/// The terms of all edges of a polygon in the ball of `radius` about the origin with one edge of another
/// polygon, and the number of logarithms.
pub(super) fn integral(small: &[Segment], radius: f64, edge: &Segment) -> (f64, u64) {
    let (mut sum, mut terms) = (0.0, 0);
    let mut stretches = vec![*edge];
    while let Some(stretch) = stretches.pop() {
        let foot = (-stretch.start.dot(stretch.direction)).clamp(0.0, stretch.length);
        let distance = (stretch.start + stretch.direction * foot).length();
        let sigma = (stretch.start.length() + stretch.end.length() - 2.0 * radius) / stretch.length;
        let (value, count) = if distance >= CLEAR * radius && sigma >= SMALLEST_SIGMA_OF_CONTOUR {
            let cone = ((distance - radius) * (distance + radius)).sqrt() / radius;
            product(small, &stretch, [cone, sigma])
        } else if stretch.length <= SHORT * radius {
            pair::integrals(small, &stretch)
        } else {
            stretches.extend(halves(&stretch));
            continue;
        };
        (sum, terms) = (sum + value, terms + count);
    }
    (sum, terms)
}

fn halves(stretch: &Segment) -> [Segment; 2] {
    let (middle, length) = (stretch.start.midpoint(stretch.end), 0.5 * stretch.length);
    [Segment { end: middle, length, ..*stretch }, Segment { start: middle, length, ..*stretch }]
}

/// The product rule; `sigmas` are a lower bound of σ on the edges of the small polygon, and σ on the stretch.
fn product(small: &[Segment], stretch: &Segment, sigmas: [f64; 2]) -> (f64, u64) {
    let [rule_a, rule_b] = sigmas.map(|sigma| UnitRule::of(points(sigma)));
    let mut sum = 0.0;
    for a in small {
        let cosine = a.direction.dot(stretch.direction);
        for (s, w) in rule_a.iter() {
            let x = a.start + a.direction * (s * a.length);
            let along = rule_b.iter().map(|(t, v)| {
                let y = stretch.start + stretch.direction * (t * stretch.length);
                v * half_log(x, y)
            });
            sum += cosine * a.length * w * along.sum::<f64>();
        }
    }
    (stretch.length * sum, (small.len() * rule_a.nodes.len() * rule_b.nodes.len()) as u64)
}

/// ½ ln(1 + z).
fn half_log(x: DVec3, y: DVec3) -> f64 {
    0.5 * (x.dot(x - 2.0 * y) / y.length_squared()).ln_1p()
}

fn points(sigma: f64) -> usize {
    let rate = 2.0 * (sigma + (sigma * sigma - 1.0).sqrt()).ln();
    ((DIGITS_OF_CONTOUR / rate).ceil().max(1.0) as usize).min(MOST_POINTS_OF_CONTOUR)
}
