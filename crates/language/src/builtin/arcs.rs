//! Control points of arcs as rational cubics.
//!
//! A quarter of a circle is the conic with the weights 1, √½, 1; raised by one degree, its weights are 1, w,
//! w, 1 with w = (1 + √2)/3.

/// A point of a text, x, y, z.
pub(super) type Point = [f64; 3];

/// Weight w of the inner control points of a quarter circle.
pub(super) const WEIGHT: f64 = (1.0 + std::f64::consts::SQRT_2) / 3.0;

/// The quarter from −45° to 45° of a circle at height z.
pub(super) fn circle(radius: f64, z: f64) -> [Point; 4] {
    section(radius * 0.5f64.sqrt(), radius * 2f64.sqrt(), z)
}

/// The side x = half of a square, run through as the quarter circle is.
pub(super) fn square(half: f64, z: f64) -> [Point; 4] {
    section(half, half, z)
}

/// Control points from (a, −a) to (a, a) with the tangents at both ends meeting at (t, 0).
fn section(a: f64, t: f64, z: f64) -> [Point; 4] {
    let root = 2f64.sqrt();
    let (x, y) = ((a + root * t) / (1.0 + root), a / (1.0 + root));
    [[a, -a, z], [x, -y, z], [x, y, z], [a, a, z]]
}
