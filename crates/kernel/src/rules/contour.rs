//! The exchange of two planar polygons of constant radiosity, as a double contour integral.
//!
//! Where both are wholly in front of each other, Stokes' theorem, applied twice, gives
//!
//! ```text
//! A_i F_ij = ∫∫ κ dA dA = 1/(2π) |∮∮ ln r dx·dy| = 1/(2π) |Σ_ab (d_a·d_b) ∫∫ ln r ds dt|
//! ```
//!
//! over pairs of edges with unit directions d (E. M. Sparrow, *A new and simpler formulation for radiative
//! angle factors*, J. Heat Transfer 85, 1963). The polygons may touch in any way and need not be convex. The
//! form depends on their position:
//!
//! * far apart compared with both sizes → `distant`, where nothing cancels;
//! * near, one much larger than the other → `unequal`, which cuts the long edges;
//! * else edge by edge (`pair`): nothing at right angles, `parallel` and `crossing` lines in closed form,
//!   `skew` ones by one quadrature.
//!
//! Σ d_a = 0 around a polygon, so that ln r may be replaced by ln r + 3/2 everywhere, which has the simplest
//! integrals. Rounding errors are some 1e-16 of the square of the polygons' extent: some 1e-16 of their area
//! unless they are slender, when the digits of their aspect ratio are lost.

mod segment;
mod crossing;
mod distant;
mod parallel;
mod skew;
mod pair;
mod unequal;

use core::f64::consts::FRAC_1_PI;
use std::borrow::Cow;

use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, Plane, ROUNDING, clip_polygon};

use distant::{Ball, Plan, Shape};
use segment::{Segment, segments};

/// Largest ratio of the polygons' radii for the sum edge by edge, which loses the digits of its square, one
/// at 4. With a smaller value more pairs go by the rules for unequal ones, which cost more.
const LARGEST_RATIO: f64 = 4.0;

/// ∫∫ κ dA dA between two convex planar polygons, corners anticlockwise seen from the front: A_i F_ij,
/// length².
///
/// Either is clipped by the plane of the other, heights below 1e-12 of the distance being ignored; nothing
/// else hides them. The error is some 1e-15 of the square of the smaller extent, and if the two are apart
/// also of the result. Polygons without area exchange nothing.
///
/// ```
/// use radiosity_kernel::polygon_exchange;
/// use radiosity_geom::DVec3;
///
/// let floor = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(DVec3::from_array);
/// let wall = [[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]].map(DVec3::from_array);
/// assert!((polygon_exchange(&floor, &wall) - 0.200_043_776_075_403_15).abs() < 1e-15);
/// ```
pub fn polygon_exchange(receiver: &[DVec3], emitter: &[DVec3]) -> f64 {
    match (normal(receiver), normal(emitter)) {
        (Some(n), Some(m)) => {
            clipped(Face { corners: receiver, normal: n }, Face { corners: emitter, normal: m }).0
        }
        _ => 0.0,
    }
}

fn normal(polygon: &[DVec3]) -> Option<DVec3> {
    let origin = polygon.first()?;
    let fan = polygon.windows(2).map(|edge| (edge[0] - origin).cross(edge[1] - origin));
    fan.sum::<DVec3>().try_normalize()
}

/// A convex polygon with its front.
#[derive(Clone, Copy)]
struct Face<'a> {
    corners: &'a [DVec3],
    /// Unit normal of the front.
    normal: DVec3,
}

impl Face<'_> {
    fn plane(&self) -> Plane {
        Plane { point: self.corners[0], normal: self.normal }
    }
}

/// The exchange (length²) of two convex polygons, and the number of logarithms.
fn clipped(p: Face, q: Face) -> (f64, u64) {
    match (in_front(p.corners, &q.plane()), in_front(q.corners, &p.plane())) {
        (Some(p), Some(q)) => exchange(&p, &q),
        _ => (0.0, 0),
    }
}

/// The exchange (length²) of two flat patches, and the number of logarithms.
pub fn patches(p: &Patch, q: &Patch) -> (f64, u64) {
    let (Patch::Flat { corners: c, normal: n }, Patch::Flat { corners: d, normal: m }) = (p, q) else {
        return (0.0, 0);
    };
    clipped(
        Face { corners: &c[..corner_count(p)], normal: *n },
        Face { corners: &d[..corner_count(q)], normal: *m },
    )
}

fn corner_count(patch: &Patch) -> usize {
    if patch.is_triangle() { 3 } else { 4 }
}

/// The part of a convex polygon in front of a plane; None if there is none.
fn in_front<'a>(polygon: &'a [DVec3], plane: &Plane) -> Option<Cow<'a, [DVec3]>> {
    let Plane { point, normal } = *plane;
    let (mut low, mut high, mut reach2) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
    for x in polygon {
        let offset = *x - point;
        let height = offset.dot(normal);
        (low, high, reach2) = (height.min(low), height.max(high), offset.length_squared().max(reach2));
    }
    let tolerance = ROUNDING * f64::sqrt(reach2);
    if high <= tolerance {
        return None;
    }
    if low >= -tolerance {
        return Some(Cow::Borrowed(polygon));
    }
    let corners = clip_polygon(polygon, point, normal);
    (corners.len() > 2).then_some(Cow::Owned(corners))
}

/// A_i F_ij (length²) of two polygons wholly in front of each other, with three corners at least, and the
/// number of logarithms.
pub(crate) fn exchange(p: &[DVec3], q: &[DVec3]) -> (f64, u64) {
    let (sum, terms) = contours(p, q);
    (0.5 * FRAC_1_PI * sum.abs(), terms)
}

/// ∮∮ ln r dx·dy.
fn contours(p: &[DVec3], q: &[DVec3]) -> (f64, u64) {
    let (ball_p, ball_q) = (Ball::about(p), Ball::about(q));
    if let Some(plan) = Plan::of(&ball_p, &ball_q) {
        return plan.integral(Shape { corners: p, ball: ball_p }, Shape { corners: q, ball: ball_q });
    }
    if !(ball_p.radius.is_normal() && ball_q.radius.is_normal()) {
        return (0.0, 0);
    }
    let (small, large, ball) = if ball_p.radius <= ball_q.radius { (p, q, ball_p) } else { (q, p, ball_q) };
    let unit = power_of_two(ball.radius);
    let (small, large) = (scaled(small, ball.center, unit), scaled(large, ball.center, unit));
    let unequal = ball_p.radius.max(ball_q.radius) > LARGEST_RATIO * ball.radius;
    let terms = large.iter().map(|edge| {
        if unequal {
            unequal::integral(&small, ball.radius / unit, edge)
        } else {
            pair::integrals(&small, edge)
        }
    });
    let (sum, count) = terms.fold((0.0, 0), |(sum, n), (term, m)| (sum + term, n + m));
    (unit * unit * sum, count)
}

/// The edges of a polygon relative to `origin`, in units of `unit`.
fn scaled(polygon: &[DVec3], origin: DVec3, unit: f64) -> Vec<Segment> {
    let corners: Vec<DVec3> = polygon.iter().map(|x| (x - origin) / unit).collect();
    segments(&corners)
}

/// The largest power of two up to a length: dividing by it is exact.
fn power_of_two(length: f64) -> f64 {
    length.log2().floor().exp2()
}

#[cfg(test)]
mod tests {
    use radiosity_geom::polygon_area;
    use serde::Deserialize;

    use super::*;

    #[derive(Deserialize)]
    struct Reference {
        factors: Vec<Case>,
        contours: Vec<Case>,
    }

    /// View factor of p to q, or exchange; the other is empty.
    #[derive(Default, Deserialize)]
    #[serde(default)]
    struct Case {
        name: String,
        p: Vec<[f64; 3]>,
        q: Vec<[f64; 3]>,
        factor: String,
        exchange: String,
    }

    impl Case {
        fn corners(&self) -> [Vec<DVec3>; 2] {
            [&self.p, &self.q].map(|polygon| polygon.iter().map(|x| DVec3::from_array(*x)).collect())
        }
    }

    fn reference() -> Reference {
        serde_json::from_str(include_str!("../../../../tests/data/polygon_exchange.json"))
            .expect("the file is valid")
    }

    /// Errors are relative to the square of the smaller extent: the area, unless polygons are slender.
    #[test]
    fn contours_agree_with_integrals_of_many_digits() {
        let cases = reference().contours;
        assert!(cases.len() > 20);
        for case in &cases {
            let [p, q] = case.corners();
            let exact: f64 = case.exchange.parse().expect("a number");
            let extent = Ball::about(&p).radius.min(Ball::about(&q).radius);
            let (one, other) = (exchange(&p, &q).0, exchange(&q, &p).0);
            assert!((one - exact).abs() < 1e-15 * extent * extent, "{}: {one} {exact}", case.name);
            assert!((other - exact).abs() < 1e-15 * extent * extent, "{}: {other} {exact}", case.name);
        }
    }

    #[test]
    fn distance_costs_no_digits() {
        for case in reference().contours.iter().filter(|case| case.name.contains(", distance ")) {
            let [p, q] = case.corners();
            let exact: f64 = case.exchange.parse().expect("a number");
            assert!((exchange(&p, &q).0 / exact - 1.0).abs() < 1e-14, "{}", case.name);
        }
    }

    #[test]
    fn view_factors_agree_with_the_references() {
        let cases = reference().factors;
        assert!(cases.len() > 18);
        for case in &cases {
            let [p, q] = case.corners();
            let exact: f64 = case.factor.parse().expect("a number");
            let factor = polygon_exchange(&p, &q) / polygon_area(&p);
            assert!((factor - exact).abs() < 1e-15, "{}: {factor} {exact}", case.name);
        }
    }

    #[test]
    fn polygons_without_area_exchange_nothing() {
        let square = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(DVec3::from_array);
        for other in [vec![], vec![DVec3::Z], vec![DVec3::Z; 4], vec![DVec3::Z, DVec3::X, DVec3::Z]] {
            assert_eq!(polygon_exchange(&square, &other), 0.0);
            assert_eq!(polygon_exchange(&other, &square), 0.0);
        }
    }
}
