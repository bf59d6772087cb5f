//! Edges on lines that cross: the double integral in closed form.
//!
//! Let s and t count from the crossing, c = cos θ ≥ 0 and r² = s² + t² − 2stc. r is homogeneous of degree
//! one, so s ∂ₛ ln r + t ∂ₜ ln r = 1, and the divergence of (s, t) ln r is 2 ln r + 1. Gauss's theorem leaves
//! integrals of ln r along single sides of the rectangle,
//!
//! ```text
//! ∫ ln r dt = [ u ln r + w atan(u/w) ] − t₁ + t₀ ,     u = t − sc ,  w = |s| sin θ ,
//! ∫∫ (ln r + 3/2) ds dt = ½ Σ_ij ± (2st − c(s² + t²)) ln r
//!                       + ½ Σ_i ± s|s| sin θ [atan(u/w)] + ½ Σ_j ± t|t| sin θ [atan(u/w)] .
//! ```
//!
//! Edges that touch lie on such lines or on parallel ones. Lines at a distance h add ½ h² ∫∫ ds dt/r², which
//! is below rounding for the h accepted here. Where the crossing is far away the terms are large and cancel:
//! such pairs are left to quadrature.

use crate::rules::contour::segment::Segment;

/// Largest distance of the crossing from the ends, relative to the longer segment. The terms grow with its
/// square and cancel: at 3 one digit is lost. With a smaller value more pairs go by quadrature, which costs
/// more.
const REACH: f64 = 3.0;
/// Largest distance h of the lines, relative to the longer segment and √sin θ: ½ h² is then 1.3e-19 of its
/// square, times sin θ.
const APART: f64 = 5e-10;
/// Largest rounding error of the crossing, relative to the longer segment: two units of rounding.
const ROUNDING: f64 = 4e-16;

/// ∫∫ (ln r + 3/2) ds dt over two segments at an angle up to 90°; None where the lines do not cross near
/// them.
pub(super) fn integral(a: &Segment, b: &Segment) -> Option<f64> {
    let size = a.length.max(b.length);
    let normal = a.direction.cross(b.direction);
    let sine2 = normal.length_squared();
    let offset = b.start - a.start;
    let foot_a = offset.cross(b.direction).dot(normal) / sine2;
    let foot_b = offset.cross(a.direction).dot(normal) / sine2;
    let (s, t) = ([-foot_a, a.length - foot_a], [-foot_b, b.length - foot_b]);
    if s.iter().chain(&t).any(|x| x.abs() > REACH * size) {
        return None;
    }
    let miss = offset + b.direction * foot_b - a.direction * foot_a;
    let slip = miss.dot(a.direction).abs().max(miss.dot(b.direction).abs());
    let crosses =
        slip <= ROUNDING * size && miss.length_squared() <= APART * APART * size * size * sine2.sqrt();
    crosses.then(|| rectangle(s, t, sine2.sqrt(), sine2 / (1.0 + a.direction.dot(b.direction))))
}

/// The integral over [s₀, s₁] × [t₀, t₁]; `lack` is 1 − cos θ.
fn rectangle(s: [f64; 2], t: [f64; 2], sine: f64, lack: f64) -> f64 {
    let mut sum = side(s[1], t, sine, lack) - side(s[0], t, sine, lack) + side(t[1], s, sine, lack)
        - side(t[0], s, sine, lack);
    for (i, s) in s.into_iter().enumerate() {
        for (j, t) in t.into_iter().enumerate() {
            sum += if i == j { corner(s, t, lack) } else { -corner(s, t, lack) };
        }
    }
    0.5 * sum
}

/// (2st − c(s² + t²)) ln r, in a form that does not cancel for small θ.
fn corner(s: f64, t: f64, lack: f64) -> f64 {
    let (d2, twist) = ((s - t) * (s - t), 2.0 * s * t * lack);
    let r2 = d2 + twist;
    if r2 > 0.0 { 0.5 * (twist - (1.0 - lack) * d2) * r2.ln() } else { 0.0 }
}

/// s|s| sin θ [atan(u/w)] along the side at s.
fn side(s: f64, t: [f64; 2], sine: f64, lack: f64) -> f64 {
    let w = s.abs() * sine;
    let [u0, u1] = t.map(|t| (t - s) + s * lack);
    s * w * (w * (u1 - u0)).atan2(w * w + u0 * u1)
}
