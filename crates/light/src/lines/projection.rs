//! The projection plane: the plane of a polygon, in which a point sees blockers in perspective.
//!
//! With a corner o of the polygon, its sides a and b from there, and the eye x, every point P is
//!
//! ```text
//! P − x = λ (o − x) + S a + T b ,      (S, T, λ) = [a, b, o − x]⁻¹ (P − x) .
//! ```
//!
//! It is seen at (s, t) = (S, T)/λ and lies before the polygon if 0 < λ < 1. The plane through x and the line
//! t = const is T − t λ = 0, linear in P.

use radiosity_geom::{Aabb, COINCIDENT, DVec3, ROUNDING};

/// The plane of a convex polygon with at least three corners, seen from a point.
#[derive(Clone, Debug)]
pub(crate) struct ProjectionPlane {
    /// The point x that sees.
    pub eye: DVec3,
    /// First corner of the polygon.
    pub origin: DVec3,
    /// First side of the polygon.
    pub along: DVec3,
    /// Last side of the polygon, reversed.
    pub across: DVec3,
    dual: [DVec3; 3],
    /// The polygon in (s, t).
    pub outline: Vec<[f64; 2]>,
    /// The planes through the eye and the sides.
    sides: Vec<SidePlane>,
    /// Largest λ of the hull, at least 1.
    depth: f64,
}

/// A plane through the eye and a side of the polygon.
#[derive(Clone, Copy, Debug)]
struct SidePlane {
    /// Inward normal, of any length.
    inward: DVec3,
    /// Least product of it with points of the hull relative to the eye, at most 0.
    lowest: f64,
}

impl ProjectionPlane {
    /// For a polygon that stands for a piece of surface inside `hull`; None where the eye lies in the
    /// polygon's plane, to rounding.
    pub(crate) fn new(eye: DVec3, polygon: &[DVec3], hull: &[DVec3]) -> Option<Self> {
        let (origin, along, across) =
            (polygon[0], polygon[1] - polygon[0], polygon[polygon.len() - 1] - polygon[0]);
        let towards = origin - eye;
        let volume = along.cross(across).dot(towards);
        if volume.abs() <= ROUNDING * along.length() * across.length() * towards.length() {
            return None;
        }
        let dual = [across.cross(towards), towards.cross(along), along.cross(across)].map(|d| d / volume);
        let seen = |y: &DVec3| [dual[0].dot(y - eye), dual[1].dot(y - eye)];
        let middle = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
        let side = |k: usize| {
            let inward = (polygon[k] - eye).cross(polygon[(k + 1) % polygon.len()] - eye);
            let inward = if inward.dot(middle - eye) < 0.0 { -inward } else { inward };
            let lowest = hull.iter().map(|y| inward.dot(y - eye)).fold(0.0, f64::min);
            SidePlane { inward, lowest }
        };
        let depth = hull.iter().map(|y| dual[2].dot(y - eye)).fold(1.0, f64::max);
        let sides = (0..polygon.len()).map(side).collect();
        let outline = polygon.iter().map(seen).collect();
        Some(Self { eye, origin, along, across, dual, outline, sides, depth })
    }

    /// This plane with s and t exchanged.
    pub(crate) fn transposed(&self) -> Self {
        let [s, t, depth] = self.dual;
        Self {
            along: self.across,
            across: self.along,
            dual: [t, s, depth],
            outline: self.outline.iter().map(|[s, t]| [*t, *s]).collect(),
            ..self.clone()
        }
    }

    /// The point of the plane at (s, t).
    pub(crate) fn at(&self, s: f64, t: f64) -> DVec3 {
        self.origin + s * self.along + t * self.across
    }

    /// (S, T, λ) of a point.
    pub(crate) fn see(&self, point: DVec3) -> DVec3 {
        self.see_direction(point - self.eye)
    }

    /// (S, T, λ) of a direction from the eye.
    pub(crate) fn see_direction(&self, direction: DVec3) -> DVec3 {
        DVec3::from_array(self.dual.map(|dual| dual.dot(direction)))
    }

    /// Normal of the plane through the eye and the line t.
    pub(crate) fn slice(&self, t: f64) -> DVec3 {
        self.dual[1] - t * self.dual[2]
    }

    /// Whether a box may reach into the pyramid between the eye and the polygon.
    pub(crate) fn reaches(&self, bounds: &Aabb) -> bool {
        let (low, high) = (bounds.min - self.eye, bounds.max - self.eye);
        let top = |n: DVec3| (low * n).max(high * n).element_sum();
        let bottom = |n: DVec3| (low * n).min(high * n).element_sum();
        bottom(self.dual[2]) < self.depth - COINCIDENT
            && top(self.dual[2]) > 0.0
            && self.sides.iter().all(|side| top(side.inward) > side.lowest)
    }

    /// Least sine of the elevation of a corner above the plane through the eye with the unit normal `normal`.
    pub(crate) fn rise(&self, normal: DVec3) -> f64 {
        let corner = |[s, t]: &[f64; 2]| (self.at(*s, *t) - self.eye).normalize_or_zero().dot(normal);
        self.outline.iter().map(corner).fold(f64::INFINITY, f64::min)
    }
}
