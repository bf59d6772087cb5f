//! Heat sinks: an extruded plate with fins, every face of which is two triangles for each of two strips, so
//! that most pairs are wholly hidden by fins of several triangles.

use std::fmt::Write;

use crate::family::{FACTOR_STAGES, Family, of_factors};

/// Heat sinks with more and more fins.
pub(crate) const FAMILY: Family = Family {
    name: "sinks",
    stages: FACTOR_STAGES,
    sizes: &[300, 600, 1_200, 2_500, 5_000],
    measure: |surfaces| of_factors(&sink(surfaces / (8 * STRIPS))),
};

/// Strips along a fin.
const STRIPS: usize = 2;
/// Width and depth of the plate, its height, and that of the fins over its bottom (m).
const WIDTH: f64 = 0.1;
const PLATE: f64 = 0.005;
const HEIGHT: f64 = 0.04;
/// Part of the width that fins stand on.
const COVERED: f64 = 0.24;

/// The text of a heat sink of so many fins, without its two ends.
fn sink(fins: usize) -> String {
    let thickness = COVERED * WIDTH / fins as f64;
    let gap = (1.0 - COVERED) * WIDTH / (fins + 1) as f64;
    let mut profile = vec![[0.0, 0.0], [WIDTH, 0.0], [WIDTH, PLATE]];
    for fin in (0..fins).rev() {
        let left = gap + fin as f64 * (gap + thickness);
        let right = left + thickness;
        profile.extend([[right, PLATE], [right, HEIGHT], [left, HEIGHT], [left, PLATE]]);
    }
    profile.push([0.0, PLATE]);
    let mut text = String::new();
    let following = profile.iter().cycle().skip(1);
    let parts = profile.iter().zip(following).flat_map(|side| (0..STRIPS).map(move |strip| (side, strip)));
    for ((from, to), strip) in parts {
        let [near, far] = [strip, strip + 1].map(|strip| WIDTH * strip as f64 / STRIPS as f64);
        let at = |[x, z]: [f64; 2], y: f64| [x, y, z];
        let [a, b, c, d] = [at(*from, near), at(*to, near), at(*to, far), at(*from, far)];
        for corners in [[a, c, b], [a, d, c]] {
            writeln!(text, "[[surfaces]]\ntriangle = {{ vertices = {corners:?} }}")
                .expect("a text takes all");
        }
    }
    text
}
