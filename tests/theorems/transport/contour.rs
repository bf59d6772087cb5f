//! The exchange of two flat outlines by their contours, independently of any quadrature over areas:
//!
//! ```text
//! A_i F_ij = 1/2π Σ_ab (d_a·d_b) ∫∫ ln r ds dt
//! ```
//!
//! over the edges a, b of both outlines with unit directions d, holes running the other way round (Stokes
//! twice; Sparrow, *A new and simpler formulation for radiative angle factors*, 1963). Both outlines are
//! clipped by the other's plane first. The inner integral is in closed form; the outer runs over Gauss rules
//! graded towards the points where edge b begins, ends, or comes nearest. Edges on one line are in closed
//! form altogether. Far apart, at distance D between the middles, ln r is replaced by ln(r/D), whose integral
//! round a contour is the same, by a plain rule.

use std::f64::consts::PI;

use radiosity_core::gauss;
use radiosity_geom::DVec3;
use radiosity_test_support::random::seeded;

use crate::transport::flat::Flat;

/// Points of a piece of the outer rule, and the ratio of neighbouring pieces.
const POINTS: usize = 16;
const RATIO: f64 = 0.2;
/// The smallest piece, as a part of the edge.
const SMALLEST: f64 = 1e-15;

/// Middles farther apart than this times the sum of both radii are far.
const FAR: f64 = 4.0;

/// A_i F_ij of two flat surfaces in an empty space, and a bound of its rounding.
pub(crate) fn exchange(p: &Flat, q: &Flat) -> [f64; 2] {
    let outlines = [loops_before(p, q), loops_before(q, p)];
    if outlines.iter().any(Vec::is_empty) {
        return [0.0; 2];
    }
    let [(from, reach_p), (to, reach_q)] = outlines.each_ref().map(|loops| ball(loops));
    let apart = to - from;
    let far = apart.length() > FAR * (reach_p + reach_q);
    let scale = reach_p.max(reach_q);
    let middles = if far { [from, to] } else { [from, from] };
    let edges = |side: usize| -> Vec<[DVec3; 2]> {
        let place = |point: &DVec3| (point - middles[side]) / scale;
        let of_loop = |points: &Vec<DVec3>| {
            let next = points.iter().cycle().skip(1);
            points.iter().zip(next).map(|(a, b)| [place(a), place(b)]).collect::<Vec<_>>()
        };
        outlines[side].iter().flat_map(of_loop).filter(|[a, b]| a != b).collect()
    };
    let (mine, theirs) = (edges(0), edges(1));
    let pair = |a: &[DVec3; 2], b: &[DVec3; 2]| {
        if far { far_pair(*a, *b, apart / scale) } else { edge_pair(*a, *b) }
    };
    let sum: f64 = mine.iter().flat_map(|a| theirs.iter().map(move |b| pair(a, b))).sum();
    let length = |edges: &[[DVec3; 2]]| -> f64 { edges.iter().map(|[a, b]| a.distance(*b)).sum() };
    let (length_p, length_q) = (length(&mine), length(&theirs));
    // Rounded corners leave a loop open by the last digit of the distances.
    let rounding = if far {
        1e-15 * length_p * length_q * (reach_p + reach_q) / apart.length()
    } else {
        2e-15 * (length_p + length_q) * (reach_p + reach_q + apart.length()) / scale
    };
    [sum, rounding].map(|x| scale * scale * x / (2.0 * PI))
}

/// Middle of all points, and how far they reach from it.
fn ball(loops: &[Vec<DVec3>]) -> (DVec3, f64) {
    let count = loops.iter().flatten().count() as f64;
    let middle = loops.iter().flatten().sum::<DVec3>() / count;
    (middle, loops.iter().flatten().map(|p| p.distance(middle)).fold(0.0, f64::max))
}

/// (d_a·d_b) ∫∫ ln(r/D) over two edges, each given from its middle, `apart` the vector D from one middle to
/// the other.
fn far_pair(a: [DVec3; 2], b: [DVec3; 2], apart: DVec3) -> f64 {
    let (along_a, along_b) = (a[1] - a[0], b[1] - b[0]);
    let cosine = along_a.dot(along_b);
    let square = apart.length_squared();
    let logarithm = |s: f64, t: f64| {
        let off = b[0] + along_b * t - a[0] - along_a * s;
        0.5 * ((2.0 * apart.dot(off) + off.length_squared()) / square).ln_1p()
    };
    let points = rule().flat_map(|(s, ws)| rule().map(move |(t, wt)| (s, t, ws * wt)));
    cosine * points.map(|(s, t, w)| w * logarithm(s, t)).sum::<f64>()
}

/// The loops of `flat` before the plane of `other`, running counter-clockwise about its front, holes
/// clockwise.
fn loops_before(flat: &Flat, other: &Flat) -> Vec<Vec<DVec3>> {
    let origin = other.outline.loops()[0][0];
    let front = other.front.normalize();
    let loops = flat.outline.loops().into_iter().enumerate().map(|(index, points)| {
        let next = points.iter().cycle().skip(1);
        let area: DVec3 = points.iter().zip(next).map(|(p, q)| (p - points[0]).cross(q - points[0])).sum();
        let mut part = clip(&points, origin, front);
        if (area.dot(flat.front) > 0.0) != (index == 0) {
            part.reverse();
        }
        part
    });
    loops.filter(|part| part.len() > 2).collect()
}

/// The part of a loop before a plane; where it falls apart, the bridges between the parts cancel.
fn clip(points: &[DVec3], origin: DVec3, normal: DVec3) -> Vec<DVec3> {
    let height = |p: DVec3| (p - origin).dot(normal);
    let mut part = Vec::new();
    for (p, q) in points.iter().zip(points.iter().cycle().skip(1)) {
        let (here, there) = (height(*p), height(*q));
        if here >= 0.0 {
            part.push(*p);
        }
        if (here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0) {
            part.push(p + (q - p) * (here / (here - there)));
        }
    }
    part
}

/// (d_a·d_b) ∫∫ ln r over two edges.
fn edge_pair(a: [DVec3; 2], b: [DVec3; 2]) -> f64 {
    let (along_a, along_b) = (a[1] - a[0], b[1] - b[0]);
    let (length_a, length_b) = (along_a.length(), along_b.length());
    let (da, db) = (along_a / length_a, along_b / length_b);
    let cosine = da.dot(db);
    if cosine.abs() < 1e-16 {
        return 0.0;
    }
    let off_line = |p: DVec3| (p - a[0]).cross(da).length();
    if off_line(b[0]).max(off_line(b[1])) < 1e-15 * (1.0 + length_a) {
        let place = |p: DVec3| (p - a[0]).dot(da);
        return cosine.signum() * collinear(length_a, [place(b[0]), place(b[1])]);
    }
    let start = a[0] - b[0];
    // Nearest point of line a to line b, where they are not parallel.
    let sine2 = 1.0 - cosine * cosine;
    let nearest = if sine2 > 1e-14 { (cosine * start.dot(db) - start.dot(da)) / sine2 } else { 0.0 };
    let ends = b.map(|p| (p - a[0]).dot(da));
    let mut breaks = vec![0.0, length_a, nearest, ends[0], ends[1]];
    breaks.retain(|x| (0.0..=length_a).contains(x));
    breaks.sort_by(f64::total_cmp);
    breaks.dedup_by(|x, y| (*x - *y).abs() <= SMALLEST * length_a);
    let inner = |t: f64| logarithm_over(a[0] + da * t, b[0], db, length_b);
    cosine * breaks.windows(2).map(|pair| graded(pair[0], pair[1], &inner)).sum::<f64>()
}

/// ∫ f from `low` to `high`, graded towards both.
fn graded(low: f64, high: f64, f: &impl Fn(f64) -> f64) -> f64 {
    let middle = 0.5 * (low + high);
    let half = middle - low;
    let mut sum = 0.0;
    let mut outer = 1.0;
    while outer * half > SMALLEST {
        let next = outer * RATIO;
        let inner = if next * half > SMALLEST { next } else { 0.0 };
        for (x, w) in rule() {
            let (t, w) = (half * (inner + (outer - inner) * x), half * (outer - inner) * w);
            sum += w * (f(low + t) + f(high - t));
        }
        outer = next;
    }
    sum
}

/// ∫₀^length ln |x − b − t d| dt in closed form.
fn logarithm_over(x: DVec3, b: DVec3, d: DVec3, length: f64) -> f64 {
    let from = x - b;
    let (along, height) = (from.dot(d), from.cross(d).length());
    let primitive = |u: f64| {
        let square = u * u + height * height;
        if square == 0.0 {
            return 0.0;
        }
        0.5 * u * square.ln() - u + if height > 0.0 { height * (u / height).atan() } else { 0.0 }
    };
    primitive(length - along) - primitive(-along)
}

/// ∫∫ ln |s − t| over s ∈ [0, length] and t between two places on the same line.
fn collinear(length: f64, [from, to]: [f64; 2]) -> f64 {
    let h = |z: f64| if z == 0.0 { 0.0 } else { 0.5 * z * z * (z.abs().ln() - 1.5) };
    let (from, to) = (from.min(to), from.max(to));
    h(length - from) + h(to) - h(length - to) - h(from)
}

fn rule() -> impl Iterator<Item = (f64, f64)> {
    static RULE: std::sync::OnceLock<([f64; POINTS], [f64; POINTS])> = std::sync::OnceLock::new();
    let (nodes, weights) = RULE.get_or_init(|| {
        let (mut nodes, mut weights) = ([0.0; POINTS], [0.0; POINTS]);
        gauss::legendre(&mut nodes, &mut weights).expect("slices are equal and not empty");
        (nodes, weights)
    });
    nodes.iter().zip(weights).map(|(x, w)| (0.5 + 0.5 * x, 0.5 * w))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use proptest::test_runner::TestRunner;

    use super::*;
    use crate::transport::flat::Outline;
    use crate::transport::shapes::pairs;
    use crate::transport::transfers::{exact_parallelograms, exact_polygons};

    #[test]
    fn contours_meet_known_form_factors() {
        for (name, [p, q], area, factor) in exact_parallelograms().into_iter().chain(exact_polygons()) {
            let [sum, rounding] = exchange(&p, &q);
            let error = (sum / area - factor).abs();
            assert!(error < 3e-14 && rounding < 1e-12, "{name}: {error:e}, {rounding:e}");
        }
    }

    /// The part of `flat` before a plane; bridges between parts do no harm to a contour.
    fn part(flat: &Flat, origin: DVec3, normal: DVec3) -> Option<Flat> {
        let mut loops = flat.outline.loops().into_iter().map(|points| clip(&points, origin, normal));
        let outer = loops.next()?;
        let holes = loops.filter(|hole| hole.len() > 2).collect();
        (outer.len() > 2).then(|| Flat::facing(Outline::Polygon { outer, holes }, flat.front))
    }

    #[test]
    fn contours_of_parts_add_up() {
        let seeded = seeded(1000, 3);
        let outcome = TestRunner::new(seeded).run(&(pairs(0..1), -1.0..1.0f64), |(pair, tilt)| {
            let [p, q] = &pair.sides;
            let outer = &q.outline.loops()[0];
            let middle = outer.iter().sum::<DVec3>() / outer.len() as f64;
            let across = (outer[1] - outer[0]) + tilt * (outer[2] - outer[1]);
            let parts = [part(q, middle, across), part(q, middle, -across)];
            let [whole, mut rounding] = exchange(p, q);
            let mut sum = 0.0;
            for part in parts.iter().flatten() {
                let [value, rounded] = exchange(p, part);
                sum += value;
                rounding += rounded;
            }
            prop_assert!((sum - whole).abs() <= rounding, "{sum:e} {whole:e} {rounding:e}");
            Ok(())
        });
        outcome.unwrap_or_else(|why| panic!("{why}"));
    }
}
