//! Parallel edges: the double integral in closed form.
//!
//! On lines at the distance h, points at s and t have the distance r, r² = u² + h², u = t − s. The second
//! antiderivative of ½ ln(u² + h²) is, up to terms linear in u,
//!
//! ```text
//! G(u) − ¾u² ,   G(u) = ¼ (u² − h²) ln(u² + h²) + h u atan(u/h) ,
//! ∫₀ᵃ ds ∫_{t₀}^{t₁} dt (ln r + 3/2) = G(t₁) − G(t₀) − G(t₁ − a) + G(t₀ − a) .
//! ```

use crate::rules::contour::segment::Segment;

/// ∫∫ (ln r + 3/2) over two segments of the same direction, up to rounding.
pub(super) fn integral(a: &Segment, b: &Segment) -> f64 {
    let along = if a.length >= b.length { a.direction } else { b.direction };
    let offset = b.start - a.start;
    let height = (0.5 * (offset + (b.end - a.end))).cross(along).length();
    let (start, end) = (offset.dot(along), (b.end - a.start).dot(along));
    let g = |u: f64| antiderivative(u, height);
    (g(end) - g(end - a.length)) - (g(start) - g(start - a.length))
}

fn antiderivative(u: f64, height: f64) -> f64 {
    let (u2, h2) = (u * u, height * height);
    let r2 = u2 + h2;
    if r2 == 0.0 {
        return 0.0;
    }
    let u = u.abs();
    0.25 * (u2 - h2) * r2.ln() + height * u * u.atan2(height)
}
