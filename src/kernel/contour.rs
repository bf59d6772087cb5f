//! The exchange of two planar polygons with constant radiosity, from their contours.
//!
//! Where both are wholly in front of each other, Stokes' theorem, applied twice, gives
//!
//! ```text
//! A_i F_ij = ∫∫ κ dA dA = 1/(2π) |∮∮ ln r dx·dy| = 1/(2π) |Σ_ab (d_a·d_b) ∫∫ ln r ds dt|
//! ```
//!
//! over pairs of edges with the unit directions d (E. M. Sparrow, *A new and simpler formulation for radiative
//! angle factors*, J. Heat Transfer 85, 1963). The polygons may touch in any way and need not be convex. Which
//! form the integral takes depends on the place:
//!
//! * far apart in relation to both sizes → [`distant`], in which nothing cancels;
//! * near, one much larger than the other → [`unequal`], which cuts the long edges;
//! * near → edge by edge ([`pair`]): at right angles nothing, [`parallel`] and [`crossing`] lines in closed form,
//!   [`skew`] ones by a single quadrature.
//!
//! Σ d_a = 0 around a polygon, so that the edge integrals may all be those of ln r + 3/2, which are the simplest.
//! Their rounding errors are some 1e-16 of the square of the polygons' extent. Of polygons as wide as they are long
//! that is some 1e-16 of their area; slender ones lose the digits of their aspect ratio.

mod crossing;
mod distant;
mod pair;
mod parallel;
mod segment;
mod skew;
mod unequal;

use core::f64::consts::FRAC_1_PI;
use std::borrow::Cow;

use radiosity_geom::{DVec3, clip_polygon};

use crate::elements::patch::Patch;
use distant::{Ball, Plan};
use segment::{Segment, segments};

/// Largest ratio of the radii of polygons that go edge by edge.
const LARGEST_RATIO: f64 = 4.0;
/// Heights below this part of the distance count as lying in a plane.
const COPLANAR: f64 = 1e-12;

/// ∫∫ κ dA dA between two convex planar polygons, corners anticlockwise seen from the front: A_i F_ij, length².
///
/// Either is clipped by the plane of the other, and nothing else hides them from each other. The error is some
/// 1e-15 of the area, and also of the result where the two are apart. Polygons without area exchange nothing.
///
/// ```
/// use radiosity::kernel::polygon_exchange;
/// use radiosity_geom::DVec3;
///
/// let floor = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(DVec3::from_array);
/// let wall = [[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]].map(DVec3::from_array);
/// assert!((polygon_exchange(&floor, &wall) - 0.200_043_776_075_403_15).abs() < 1e-15);
/// ```
pub fn polygon_exchange(receiver: &[DVec3], emitter: &[DVec3]) -> f64 {
    match (normal(receiver), normal(emitter)) {
        (Some(n), Some(m)) => clipped((receiver, n), (emitter, m)).0,
        _ => 0.0,
    }
}

fn normal(polygon: &[DVec3]) -> Option<DVec3> {
    let origin = polygon.first()?;
    let fan = polygon.windows(2).map(|edge| (edge[0] - origin).cross(edge[1] - origin));
    fan.sum::<DVec3>().try_normalize()
}

/// The exchange of two convex polygons with the unit normals of their fronts (length²), and the number of
/// logarithms it took.
fn clipped((p, n): (&[DVec3], DVec3), (q, m): (&[DVec3], DVec3)) -> (f64, u64) {
    match (in_front(p, q[0], m), in_front(q, p[0], n)) {
        (Some(p), Some(q)) => counted(&p, &q),
        _ => (0.0, 0),
    }
}

/// The exchange of two flat patches, likewise.
pub(super) fn patches(p: &Patch, q: &Patch) -> (f64, u64) {
    let (Patch::Flat { corners: c, normal: n }, Patch::Flat { corners: d, normal: m }) = (p, q) else {
        return (0.0, 0);
    };
    clipped((&c[..corner_count(p)], *n), (&d[..corner_count(q)], *m))
}

fn corner_count(patch: &Patch) -> usize {
    if patch.is_triangle() { 3 } else { 4 }
}

/// The part of a convex polygon in front of a plane; None if nothing of it is.
fn in_front(polygon: &[DVec3], point: DVec3, normal: DVec3) -> Option<Cow<'_, [DVec3]>> {
    let (mut low, mut high, mut reach2) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
    for x in polygon {
        let offset = *x - point;
        let height = offset.dot(normal);
        (low, high, reach2) = (height.min(low), height.max(high), offset.length_squared().max(reach2));
    }
    let tolerance = COPLANAR * f64::sqrt(reach2);
    if high <= tolerance {
        return None;
    }
    if low >= -tolerance {
        return Some(Cow::Borrowed(polygon));
    }
    let corners = clip_polygon(polygon, point, normal);
    (corners.len() > 2).then_some(Cow::Owned(corners))
}

/// A_i F_ij of two polygons wholly in front of each other, each with three corners at least (length²).
#[cfg(test)]
pub(super) fn exchange(p: &[DVec3], q: &[DVec3]) -> f64 {
    counted(p, q).0
}

/// The exchange, and the number of logarithms it took.
fn counted(p: &[DVec3], q: &[DVec3]) -> (f64, u64) {
    let (sum, terms) = contours(p, q);
    (0.5 * FRAC_1_PI * sum.abs(), terms)
}

/// ∮∮ ln r dx·dy.
fn contours(p: &[DVec3], q: &[DVec3]) -> (f64, u64) {
    let (ball_p, ball_q) = (Ball::about(p), Ball::about(q));
    if let Some(plan) = Plan::of(&ball_p, &ball_q) {
        return plan.integral((p, ball_p), (q, ball_q));
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

/// The edges of a polygon in units of `unit`, seen from `origin`.
fn scaled(polygon: &[DVec3], origin: DVec3, unit: f64) -> Vec<Segment> {
    let corners: Vec<DVec3> = polygon.iter().map(|x| (x - origin) / unit).collect();
    segments(&corners)
}

/// The power of two below a length: dividing by it rounds nothing.
fn power_of_two(length: f64) -> f64 {
    length.log2().floor().exp2()
}

#[cfg(test)]
mod tests {
    use super::*;
    use radiosity_geom::polygon_area;
    use serde::Deserialize;

    #[derive(Deserialize)]
    struct Reference {
        factors: Vec<Case>,
        contours: Vec<Case>,
    }

    #[derive(Deserialize)]
    struct Case {
        name: String,
        p: Vec<[f64; 3]>,
        q: Vec<[f64; 3]>,
        #[serde(alias = "exchange")]
        factor: String,
    }

    impl Case {
        fn corners(&self) -> [Vec<DVec3>; 2] {
            [&self.p, &self.q].map(|polygon| polygon.iter().map(|x| DVec3::from_array(*x)).collect())
        }
    }

    fn reference() -> Reference {
        serde_json::from_str(include_str!("../../tests/data/polygon_exchange.json"))
            .expect("the file is valid")
    }

    #[test]
    fn table() {
        let reference = reference();
        for case in &reference.contours {
            let [p, q] = case.corners();
            let exact: f64 = case.factor.parse().unwrap();
            let start = std::time::Instant::now();
            let mut v = 0.0;
            for _ in 0..100 {
                v = std::hint::black_box(exchange(std::hint::black_box(&p), &q));
            }
            let t = start.elapsed().as_secs_f64() / 100.0;
            let area = polygon_area(&p).min(polygon_area(&q));
            println!(
                "{:45} {exact:.5e} rel {:8.1e} of area {:8.1e} sym {:8.1e} terms {:5} {:.2} us",
                case.name,
                (v - exact) / exact,
                (v - exact) / area,
                (exchange(&q, &p) - v) / v,
                counted(&p, &q).1,
                t * 1e6
            );
        }
        for case in &reference.factors {
            let [p, q] = case.corners();
            let exact: f64 = case.factor.parse().unwrap();
            let area = polygon_area(&p);
            let start = std::time::Instant::now();
            let mut v = 0.0;
            for _ in 0..100 {
                v = std::hint::black_box(polygon_exchange(std::hint::black_box(&p), &q)) / area;
            }
            let t = start.elapsed().as_secs_f64() / 100.0;
            println!(
                "{:45} {exact:.5e} rel {:8.1e} abs {:8.1e} {:.2} us",
                case.name,
                (v - exact) / exact,
                v - exact,
                t * 1e6
            );
        }
    }
}
