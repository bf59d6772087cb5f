//! Directions along a spiral that turns by the golden angle, π (3 − √5), from one to the next.

use std::f64::consts::PI;

use radiosity_geom::DVec3;

/// Sine and cosine of the turn of a direction about the axis of the spiral, by its place.
pub(crate) fn turn(place: usize) -> (f64, f64) {
    (place as f64 * (PI * (3.0 - 5.0_f64.sqrt()))).sin_cos()
}

/// Unit vector number `place` of `count` that are spread evenly over the sphere.
pub(crate) fn direction(place: usize, count: usize) -> DVec3 {
    let height = 1.0 - (2 * place + 1) as f64 / count as f64;
    let (sine, cosine) = turn(place);
    let across = (1.0 - height * height).sqrt();
    DVec3::new(across * cosine, across * sine, height)
}
