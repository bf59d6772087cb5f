//! Directions along a spiral that turns by the golden angle, π (3 − √5), from one to the next.

use std::f64::consts::PI;

/// Sine and cosine of the turn of a direction about the axis of the spiral, by its place.
pub(crate) fn turn(place: usize) -> (f64, f64) {
    (place as f64 * (PI * (3.0 - 5.0_f64.sqrt()))).sin_cos()
}
