//! Lambert's form of a polygon at a point, against the same form in double-double.
//!
//! ```text
//! E = 1/(2π) Σ_k θ_k n·(a_k × b_k)/|a_k × b_k|
//! ```
//!
//! Each product n·(a × b)/|a × b| is rounded to ε/θ, so a term to about ε whatever its size: the form keeps
//! digits of 1, not of E, and a small part of the sky is better summed by points.

use radiosity::kernel::irradiance::visible_polygon::irradiance;
use radiosity_geom::DVec3;

use crate::double::Double;
use crate::row::Row;
use radiosity_test_support::random::Random;

type Vector = [Double; 3];

fn cross(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

fn dot(a: Vector, b: Vector) -> Double {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The form for a polygon before the horizon.
fn exact(x: DVec3, n: DVec3, polygon: &[DVec3]) -> Double {
    let wide = |v: DVec3| v.to_array().map(Double::from);
    let from = |v: &DVec3| [0, 1, 2].map(|k| Double::from(v[k]) - Double::from(x[k]));
    let mut sum = Double::ZERO;
    for (v, w) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (a, b) = (from(v), from(w));
        let across = cross(a, b);
        let sine = dot(across, across).sqrt();
        sum = sum + sine.atan2(dot(a, b)) * dot(wide(n), across) / sine;
    }
    sum.abs() / (Double::from(2.0) * Double::PI)
}

/// A parallelogram of sides about `size` with its middle at `middle`; None if it is a sliver or reaches below
/// z = 0.
fn polygon(random: &mut Random, middle: DVec3, size: f64) -> Option<Vec<DVec3>> {
    let mut any = || DVec3::from_array([0; 3].map(|_| random.between(-1.0, 1.0))).normalize();
    let (u, v) = (any() * 0.5 * size, any() * 0.5 * size);
    let corners: Vec<DVec3> = [-u - v, u - v, u + v, v - u].iter().map(|d| middle + d).collect();
    let wide = u.cross(v).length() > 0.05 * size * size;
    (wide && corners.iter().all(|p| p.z > 0.0)).then_some(corners)
}

/// A unit square that hovers over the point at `height`, tilted by about as much.
fn cover(random: &mut Random, height: f64) -> Vec<DVec3> {
    let [x, y, tilt] = [-0.4, -0.4, -0.9].map(|low: f64| random.between(low, -low));
    let corner = |(u, v): (f64, f64)| DVec3::new(x + u, y + v, height * (1.0 + tilt * (u + v)));
    [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)].map(corner).to_vec()
}

/// Tries `count` polygons of those drawn.
fn hunt(row: &Row, count: usize, mut draw: impl FnMut(&mut Random) -> Option<Vec<DVec3>>) {
    let mut random = Random(2);
    let mut tried = 0;
    while tried < count {
        let Some(corners) = draw(&mut random) else { continue };
        let ours = Double::from(irradiance(DVec3::ZERO, DVec3::Z, &corners));
        let error = (ours - exact(DVec3::ZERO, DVec3::Z, &corners)).abs();
        row.add(error.to_f64() / f64::EPSILON, || format!("{corners:?}"));
        tried += 1;
    }
}

/// A direction above the horizon.
fn direction(random: &mut Random, height: f64) -> DVec3 {
    let angle = random.between(0.0, std::f64::consts::TAU);
    DVec3::new(angle.cos(), angle.sin(), height).normalize()
}

fn all(count: usize) {
    let row = |range: &str| Row::new("Lambert's form at a point", range, 8.0, "ε of 1");
    hunt(&row("distance 0.5 to 3 sizes"), count, |random| {
        let (height, distance) = (random.between(0.0, 3.0), random.between(0.5, 3.0));
        let middle = direction(random, height) * distance;
        polygon(random, middle, 1.0)
    });
    hunt(&row("sizes to 1e-8 of the distance"), count, |random| {
        let (height, size) = (random.between(0.0, 3.0), random.power(-8.0, 0.0));
        let middle = direction(random, height);
        polygon(random, middle, size)
    });
    hunt(&row("heights to 1e-8 over the horizon"), count, |random| {
        let (height, part) = (random.power(-8.0, -1.0), random.between(0.1, 1.0));
        let middle = direction(random, height);
        polygon(random, middle, part * height)
    });
    hunt(&row("distances to 1e-8 of the size"), count, |random| {
        let height = random.power(-8.0, 0.0);
        Some(cover(random, height))
    });
}

#[test]
fn lamberts_form_keeps_its_digits() {
    all(200);
}

#[test]
#[ignore = "many cases"]
fn lamberts_form_keeps_its_digits_everywhere() {
    all(100_000);
}
