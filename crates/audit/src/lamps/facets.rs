//! Points on a flat lamp, even over the solid angle in which a point sees it.
//!
//! The lamp is cut into triangles. With the unit vectors A, B, C to the corners of one, its angles α, β, γ and the
//! solid angle Ω = α + β + γ − π, the part s Ω is that of the triangle A, B, C′, where C′ lies on the arc from A
//! to C and
//!
//! ```text
//! q = A·C′ = ((v c − u w) cos α − v) / ((v w + u c) sin α) ,     w, c = sin, cos (s Ω − α) ,
//! u = c − cos α ,     v = w + sin α (A·B) ;
//! ```
//!
//! on the arc from B to C′ the direction P has B·P = 1 − t (1 − B·C′).
//!
//! Reference: J. Arvo, *Stratified sampling of spherical triangles*, SIGGRAPH 1995.

use radiosity_geom::{DVec3, Surface};

use super::on_lamp::OnLamp;
use crate::spread::triangles;

/// Triangles of a lamp beyond which points are drawn by area: each takes as long as a tenth of a ray.
const MOST: usize = 8;

/// Squared radius over squared distance below which points are drawn by area: density per solid angle then hardly
/// varies over the lamp.
const FAR: f64 = 0.2;

/// Height over the lamp's plane, as a part of its radius, up to which points are drawn by area: their directions are
/// then all rounding.
const FLAT: f64 = 1e-9;

/// Solid angle of a triangle below which points are drawn by area: roundings of 10⁻¹⁶ over it then move them.
const NARROW: f64 = 1e-6;

/// A flat lamp of few triangles.
#[derive(Clone, Debug)]
pub(super) struct Facets {
    triangles: Vec<[DVec3; 3]>,
    center: DVec3,
    radius_squared: f64,
    normal: DVec3,
}

impl Facets {
    /// The facets of a flat surface of few triangles.
    pub(super) fn of(shape: &dyn Surface) -> Option<Self> {
        let region = shape.region()?;
        let triangles: Vec<[DVec3; 3]> = triangles(region).collect();
        let corners = || triangles.iter().flatten().copied();
        let center = corners().sum::<DVec3>() / (3.0 * triangles.len() as f64);
        let radius_squared = corners().map(|corner| corner.distance_squared(center)).fold(0.0, f64::max);
        let normal = region.normal();
        (triangles.len() <= MOST).then_some(Self { triangles, center, radius_squared, normal })
    }

    /// Solid angle of each triangle for a point; None where points are drawn by area.
    fn angles(&self, from: DVec3) -> Option<([f64; MOST], f64)> {
        let step = from - self.center;
        let is_far = self.radius_squared < FAR * step.length_squared();
        if is_far || self.normal.dot(step) <= FLAT * self.radius_squared.sqrt() {
            return None;
        }
        let mut angles = [0.0; MOST];
        for (angle, corners) in angles.iter_mut().zip(&self.triangles) {
            let own = solid_angle(corners.map(|corner| (corner - from).normalize_or_zero()));
            if own < NARROW {
                return None;
            }
            *angle = own;
        }
        Some((angles, angles.iter().sum()))
    }

    /// Density per solid angle of its points for a point; None where they are drawn by area.
    pub(super) fn density(&self, from: DVec3) -> Option<f64> {
        self.angles(from).map(|(_, sum)| sum.recip())
    }

    /// The point of two draws for a point; None where it is to be drawn by area.
    pub(super) fn point(&self, [s, t]: [f64; 2], from: DVec3) -> Option<OnLamp> {
        let (angles, sum) = self.angles(from)?;
        let mut left = s * sum;
        let mut chosen = 0;
        for (place, angle) in angles.iter().enumerate().take(self.triangles.len()) {
            chosen = place;
            if left < *angle {
                break;
            }
            left -= angle;
        }
        let part = (left / angles[chosen]).clamp(0.0, 1.0);
        let corners = self.triangles[chosen];
        let along =
            within(corners.map(|corner| (corner - from).normalize_or_zero()), part * angles[chosen], t);
        let reach = (corners[0] - from).dot(self.normal) / along.dot(self.normal);
        let point = from + reach * along;
        let parameters = [0.0; 2];
        Some(OnLamp { point, parameters, along, density: sum.recip() })
    }
}

/// Solid angle of the triangle of three unit vectors (A. van Oosterom, J. Strackee, 1983).
fn solid_angle([a, b, c]: [DVec3; 3]) -> f64 {
    let volume = a.dot(b.cross(c)).abs();
    2.0 * volume.atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}

/// The unit vector across `axis` in the plane of it and `other`.
fn across(other: DVec3, axis: DVec3) -> DVec3 {
    (other - other.dot(axis) * axis).normalize_or_zero()
}

/// The direction in the triangle of three unit vectors whose first draw leaves the solid angle `cut` on the side of b.
fn within([a, b, c]: [DVec3; 3], cut: f64, t: f64) -> DVec3 {
    let (ab, ac) = (across(b, a), across(c, a));
    let cos_alpha = ab.dot(ac).clamp(-1.0, 1.0);
    let alpha = cos_alpha.acos();
    let sin_alpha = alpha.sin();
    let (w, x) = (cut - alpha).sin_cos();
    let u = x - cos_alpha;
    let v = w + sin_alpha * a.dot(b);
    let q = ((v * x - u * w) * cos_alpha - v) / ((v * w + u * x) * sin_alpha);
    let q = if q.is_finite() { q.clamp(-1.0, 1.0) } else { 1.0 };
    let end = q * a + (1.0 - q * q).sqrt() * ac;
    let z = 1.0 - t * (1.0 - end.dot(b));
    z * b + (1.0 - z * z).max(0.0).sqrt() * across(end, b)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// An octant has the solid angle π/2, and of its points, drawn evenly, the mean of z is that of the octant,
    /// ∫ z dω / Ω = (π/4) / (π/2).
    #[test]
    fn directions_fill_a_triangle_evenly() {
        let octant = [DVec3::X, DVec3::Y, DVec3::Z];
        assert!((solid_angle(octant) - PI / 2.0).abs() < 1e-15);
        const SIDE: usize = 300;
        let draw = |k: usize| (k as f64 + 0.5) / SIDE as f64;
        let all = (0..SIDE * SIDE).map(|k| within(octant, draw(k / SIDE) * PI / 2.0, draw(k % SIDE)));
        let mean = all.sum::<DVec3>() / (SIDE * SIDE) as f64;
        // Midpoints err by the square root at the corner.
        assert!((mean - DVec3::splat(0.5)).length() < 3e-5, "{mean}");
    }
}
