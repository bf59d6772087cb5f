//! Random disks, rings, cylinders and cones over polygons, and what they exchange.
//!
//! ```text
//! A F = ∫ E(x) dA ,     E(x) = −1/2π Σ_k β_k n·γ_k ,
//! ```
//!
//! by Lambert's form, γ_k the unit normal of the triangle of x and side k of what x sees of the polygon,
//! counter-clockwise about its front, and β_k the side's angle at x. A disk has one horizon, and of it only
//! the segment before the polygon's plane counts: there E is smooth. A ring is one disk less another.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use proptest::prelude::*;
use radiosity::elements::rule::UnitRule;
use radiosity_geom::shapes::{Cone, Disk, FULL_TURN, Polygon};
use radiosity_geom::{DVec3, Surface, clip_polygon};
use radiosity_test_support::shapes::tube;

/// A disk, or a ring.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ring {
    pub center: DVec3,
    pub normal: DVec3,
    pub radius: f64,
    pub inner: f64,
}

/// A cylinder, or a cone: radii at the base and at the top.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tube {
    pub base: DVec3,
    pub axis: DVec3,
    pub radii: [f64; 2],
}

/// Panels of the rule for a disk and, finer, to judge it by; points of each.
const PANELS: [usize; 2] = [4, 6];
const POINTS: usize = 16;
/// Panels of the rule for a tube, around and along, and their points: E has kinks.
const TUBE_PANELS: [usize; 2] = [128, 32];
const TUBE_POINTS: usize = 6;

impl Ring {
    pub(crate) fn surface(&self) -> Arc<dyn Surface> {
        let disk = Disk::new(self.center, self.normal, self.radius, self.inner, FULL_TURN);
        Arc::new(disk.expect("a disk"))
    }

    pub(crate) fn area(&self) -> f64 {
        0.5 * TAU * (self.radius * self.radius - self.inner * self.inner)
    }

    /// ∫∫κ between the disk and a polygon to about 1e-9 of itself.
    pub(crate) fn exchange(&self, polygon: &[DVec3]) -> f64 {
        let seen = clip_polygon(polygon, self.center, self.normal);
        if seen.len() < 3 {
            return 0.0;
        }
        let all = PANELS.map(|panels| {
            let whole = self.segment(self.radius, polygon, &seen, panels);
            whole - if self.inner > 0.0 { self.segment(self.inner, polygon, &seen, panels) } else { 0.0 }
        });
        assert!((all[0] - all[1]).abs() <= 1e-9 * all[1], "{all:?} {self:?} {polygon:?}");
        all[1]
    }

    /// ∫E dA over what of the disk of this radius is before the polygon's plane: v ≥ −h/g for the height
    /// h + g v over it, with v = r sin φ and u = r cos φ (2t − 1) in the disk.
    fn segment(&self, radius: f64, polygon: &[DVec3], seen: &[DVec3], panels: usize) -> f64 {
        let up = normal(polygon);
        let across = up - self.normal * up.dot(self.normal);
        let steepness = across.length();
        let height = up.dot(self.center - polygon[0]);
        let low = (-height / (radius * steepness).max(1e-300)).max(-1.0);
        if low >= 1.0 {
            return 0.0;
        }
        let v = across.try_normalize().unwrap_or_else(|| self.normal.any_orthonormal_vector());
        let (u, start) = (self.normal.cross(v), low.asin());
        let stretch = FRAC_PI_2 - start;
        let column = |(s, ws): (f64, f64)| {
            let (sin, cos) = (start + stretch * s).sin_cos();
            let at = |t: f64| self.center + radius * (sin * v + cos * (2.0 * t - 1.0) * u);
            let row = panelled(panels, POINTS).map(|(t, wt)| wt * irradiance(at(t), self.normal, seen));
            2.0 * ws * stretch * radius * radius * cos * cos * row.sum::<f64>()
        };
        panelled(panels, POINTS).map(column).sum()
    }
}

impl Tube {
    pub(crate) fn surface(&self) -> Arc<dyn Surface> {
        let [low, high] = self.radii;
        if low == high {
            return Arc::new(tube(self.base, self.axis, low));
        }
        Arc::new(Cone::new(self.base, self.axis, low, high, FULL_TURN).expect("a cone"))
    }

    pub(crate) fn area(&self) -> f64 {
        let [low, high] = self.radii;
        0.5 * TAU * (low + high) * self.axis.length().hypot(low - high)
    }

    /// ∫∫κ between the tube and a polygon to some 1e-6 of itself.
    pub(crate) fn exchange(&self, polygon: &[DVec3]) -> f64 {
        let ([low, high], up, front) = (self.radii, self.axis.normalize(), normal(polygon));
        let slope = (low - high) / self.axis.length();
        let x = up.any_orthonormal_vector();
        let y = up.cross(x);
        let place = |around: f64, along: f64| {
            let (sin, cos) = (TAU * around).sin_cos();
            let (out, radius) = (cos * x + sin * y, low + (high - low) * along);
            let position = self.base + radius * out + along * self.axis;
            let normal = (out + slope * up).normalize();
            if front.dot(position - polygon[0]) <= 0.0 {
                return 0.0;
            }
            let seen = clip_polygon(polygon, position, normal);
            radius * if seen.len() > 2 { irradiance(position, normal, &seen) } else { 0.0 }
        };
        let line = |(s, ws): (f64, f64)| {
            ws * panelled(TUBE_PANELS[1], TUBE_POINTS).map(|(t, wt)| wt * place(s, t)).sum::<f64>()
        };
        let sum = panelled(TUBE_PANELS[0], TUBE_POINTS).map(line).sum::<f64>();
        TAU * self.axis.length().hypot(low - high) * sum
    }
}

/// The front of a polygon.
pub(crate) fn normal(polygon: &[DVec3]) -> DVec3 {
    let sides = polygon.windows(2).map(|side| (side[0] - polygon[0]).cross(side[1] - polygon[0]));
    sides.sum::<DVec3>().normalize()
}

/// E from a polygon whose front the point is before, and which lies above its horizon.
pub(crate) fn irradiance(x: DVec3, n: DVec3, polygon: &[DVec3]) -> f64 {
    let side = |k: usize| {
        let (a, b) = (polygon[k] - x, polygon[(k + 1) % polygon.len()] - x);
        let cross = a.cross(b);
        let length = cross.length();
        if length > 0.0 { length.atan2(a.dot(b)) * n.dot(cross) / length } else { 0.0 }
    };
    -(0..polygon.len()).map(side).sum::<f64>() / TAU
}

/// Nodes and weights of so many Gauss rules side by side on [0, 1].
fn panelled(panels: usize, points: usize) -> impl Iterator<Item = (f64, f64)> {
    let part = 1.0 / panels as f64;
    let node = move |k: usize, (s, w): (f64, f64)| ((k as f64 + s) * part, w * part);
    (0..panels).flat_map(move |k| UnitRule::of(points).iter().map(move |pair| node(k, pair)))
}

pub(crate) fn polygon_surface(corners: &[DVec3]) -> Arc<dyn Surface> {
    Arc::new(Polygon::new(corners.to_vec(), Vec::new()).expect("it is convex"))
}

/// A unit vector.
fn direction() -> impl Strategy<Value = DVec3> {
    (-1.0..1.0f64, 0.0..TAU).prop_map(|(z, angle)| {
        let (sin, cos) = angle.sin_cos();
        DVec3::new((1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin, z)
    })
}

/// A convex polygon about the origin within a radius of 1.2, its corners on an ellipse.
fn polygon() -> impl Strategy<Value = Vec<DVec3>> {
    let corners = prop::collection::vec(-0.3..0.3f64, 3..8usize);
    (corners, 0.3..1.2f64, 0.3..1.2f64, direction()).prop_map(|(shifts, a, b, up)| {
        let x = up.any_orthonormal_vector();
        let y = up.cross(x);
        let corner = |(k, shift): (usize, &f64)| {
            let (sin, cos) = (TAU * (k as f64 + shift) / shifts.len() as f64).sin_cos();
            a * cos * x + b * sin * y
        };
        shifts.iter().enumerate().map(corner).collect()
    })
}

/// A place before a polygon or beside it, so far that a ball of the radius keeps a distance of `gap`.
fn beside(polygon: &[DVec3], radius: f64, gap: f64, rise: f64, angle: f64) -> DVec3 {
    let up = normal(polygon);
    let reach = polygon.iter().map(|corner| corner.length()).fold(0.0, f64::max);
    let x = up.any_orthonormal_vector();
    let out = angle.cos() * x + angle.sin() * up.cross(x);
    (reach + radius + gap) * (rise.cos() * out + rise.sin() * up)
}

/// Disks and rings whose planes cut a polygon, and often the polygon's plane them.
pub(crate) fn rings_beside_polygons() -> impl Strategy<Value = (Ring, Vec<DVec3>)> {
    let place = (0.1..1.2f64, 0.05..1.5f64, -0.2..1.4f64, 0.0..TAU);
    let aim = (prop::array::uniform2(-0.3..0.3f64), 0.0..TAU, prop_oneof![Just(0.0), 0.1..0.95f64]);
    (polygon(), place, aim).prop_map(|(polygon, (radius, gap, rise, angle), (aim, turn, inner))| {
        let center = beside(&polygon, radius, gap, rise, angle);
        // The plane passes through a point of the polygon.
        let towards = (aim[0] * polygon[0] + aim[1] * polygon[1] - center).normalize();
        let x = towards.any_orthonormal_vector();
        let normal = turn.cos() * x + turn.sin() * towards.cross(x);
        (Ring { center, normal, radius, inner: inner * radius }, polygon)
    })
}

/// Small disks over a large floor.
pub(crate) fn disks_over_a_floor() -> impl Strategy<Value = (Ring, Vec<DVec3>)> {
    let floor = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 3.5, 0.0], [0.0, 3.5, 0.0]].map(DVec3::from_array);
    let place = (0.0..4.0f64, 0.0..3.5f64, 0.05..2.0f64);
    (place, 0.05..0.8f64, direction()).prop_map(move |((x, y, gap), radius, normal)| {
        let center = DVec3::new(x, y, gap + radius);
        (Ring { center, normal, radius, inner: 0.0 }, floor.to_vec())
    })
}

/// Cylinders and cones, some with a tip, beside polygons.
pub(crate) fn tubes_beside_polygons() -> impl Strategy<Value = (Tube, Vec<DVec3>)> {
    let place = (0.1..0.7f64, 0.2..1.5f64, 0.05..1.5f64, -0.2..1.4f64, 0.0..TAU);
    let taper = prop::sample::select(vec![1.0, 0.5, 0.0]);
    (polygon(), place, direction(), taper).prop_map(
        |(polygon, (radius, length, gap, rise, angle), up, taper)| {
            let middle = beside(&polygon, radius.hypot(0.5 * length), gap, rise, angle);
            let tube =
                Tube { base: middle - 0.5 * length * up, axis: length * up, radii: [radius, taper * radius] };
            (tube, polygon)
        },
    )
}
