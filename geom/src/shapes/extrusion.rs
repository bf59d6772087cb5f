//! Cubic Bézier curve moved along a straight line: X(u, v) = C(s) + ½(1 + v) d, s = ½(1 + u).
//!
//! Front C′ × d. Area |d| times the length of the curve seen along d, by quadrature. Range: a curve that
//! moves across d.
//!
//! Ray o + t w: (C(s) − o) · (w × d) = 0, a cubic in s; then t and v where the ray passes the ruling.

use super::check_edge;
use super::fold::{places, turns_back};
use crate::bernstein::{evaluate, restrict};
use crate::roots::bernstein;
use crate::{Aabb, ConvexSolid, Hit, Jet, Outline, Ray, Rect, ShapeError, Surface};
use glam::{DVec2, DVec3};

/// A curved wall, straight in one direction.
#[derive(Clone, Debug)]
pub struct Extrusion {
    curve: [DVec3; 4],
    direction: DVec3,
}

impl Extrusion {
    /// The sheet swept by the cubic Bézier curve with control points `curve` on its way along `direction`.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, a direction of no length, a curve that runs along the direction only or
    /// turns back within a plane.
    pub fn new(curve: [DVec3; 4], direction: DVec3) -> Result<Extrusion, ShapeError> {
        for x in curve {
            super::check_finite("curve", x)?;
        }
        check_edge("direction", direction)?;
        let extent = Aabb::around(curve).diagonal();
        let spread = curve.map(|x| (x - curve[0]).cross(direction).length());
        if spread.iter().all(|x| *x <= 1e-9 * extent * direction.length()) {
            return Err(ShapeError::NoArea { field: "curve".into() });
        }
        let across: Vec<DVec3> = places().map(|s| evaluate(&curve, s).1.cross(direction)).collect();
        if turns_back(&across) {
            return Err(ShapeError::TurnsBack { field: "curve".into() });
        }
        Ok(Extrusion { curve, direction })
    }

    /// t and v where the ray's line passes the ruling through `start`.
    fn on_ruling(&self, ray: &Ray, start: DVec3) -> (f64, f64) {
        let normal = ray.direction.cross(self.direction);
        let gap = start - ray.origin;
        let scale = 1.0 / normal.length_squared();
        let t = scale * gap.cross(self.direction).dot(normal);
        (t, 2.0 * scale * gap.cross(ray.direction).dot(normal) - 1.0)
    }
}

impl Surface for Extrusion {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let (position, slope) = evaluate(&self.curve, 0.5 * (1.0 + u));
        let (du, dv) = (0.5 * slope, 0.5 * self.direction);
        let cross = du.cross(dv);
        let across = |slope: DVec3| slope.cross(self.direction).try_normalize();
        // Where the curve stops for a moment (coinciding control points), its direction a little farther
        // inside.
        let nudged = || evaluate(&self.curve, 0.5 * (1.0 + (1.0 - 1e-6) * u)).1;
        let normal = across(slope).or_else(|| across(nudged())).unwrap_or(DVec3::Z);
        Jet { position: position + (1.0 + v) * dv, du, dv, normal, area: cross.length() }
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        let [low, high] = rect.u.map(|u| 0.5 * (1.0 + u));
        let part = restrict(&self.curve, low, high);
        let ends = rect.v.map(|v| 0.5 * (1.0 + v) * self.direction);
        Aabb::around(ends.into_iter().flat_map(|end| part.map(|x| x + end)))
    }

    fn solid(&self) -> Option<ConvexSolid> {
        let axes = <[DVec3; 2]>::from(self.direction.normalize().any_orthonormal_pair());
        let origin = self.curve[0];
        let seen = |x: DVec3| DVec2::from_array(axes.map(|axis| axis.dot(x - origin)));
        let points = self.curve.map(seen);
        let turn: f64 = points[1..].windows(2).map(|pair| pair[0].perp_dot(pair[1])).sum();
        let outline = Outline::cubic(points, 1.0_f64.copysign(turn))?;
        Some(ConvexSolid::Moved { origin, axes, outline })
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let normal = ray.direction.cross(self.direction);
        let height = self.curve.map(|x| (x - ray.origin).dot(normal));
        // A little beyond both ends, so that seams are closed.
        let wide = [-Hit::SEAM, 1.0 + Hit::SEAM];
        let mut best = None;
        bernstein(restrict(&height, wide[0], wide[1]), |x| {
            let s = wide[0] + x * (wide[1] - wide[0]);
            let (t, v) = self.on_ruling(ray, evaluate(&self.curve, s).0);
            if let Some(hit) = Hit::accept(ray, t, 2.0 * s - 1.0, v) {
                best = Hit::nearer(best, hit);
            }
        });
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_name_the_field() {
        let [o, x, z] = [DVec3::ZERO, DVec3::X, DVec3::Z];
        assert_eq!(Extrusion::new([o, x, x, z], o).unwrap_err().field(), "direction");
        assert_eq!(Extrusion::new([o; 4], z).unwrap_err(), ShapeError::NoArea { field: "curve".into() });
        assert_eq!(
            Extrusion::new([o, z, 3.0 * z, z], z).unwrap_err(),
            ShapeError::NoArea { field: "curve".into() }
        );
    }

    #[test]
    fn a_hit_in_the_middle_of_a_wave_lies_on_it() {
        let point = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let wave = [point(0.0, -0.1), point(1.0, 3.0), point(2.0, -3.0), point(3.0, 0.1)];
        let sheet = Extrusion::new(wave, DVec3::Z).unwrap();
        let hit = sheet.intersect(&Ray::segment(point(1.0, 0.0), point(2.0, 0.0))).unwrap();
        assert!((hit.t - 0.5).abs() < 1e-15 && hit.u.abs() < 1e-15, "{hit:?}");
    }

    #[test]
    fn a_curve_that_starts_at_rest_has_a_normal() {
        let [o, x, y, z] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let sheet = Extrusion::new([o, o, x, x + y], z).unwrap();
        assert!(sheet.jet(-1.0, 0.0).normal.distance(-y) < 1e-5);
        assert!(!sheet.occludes(&Ray::new(-z + x, z)));
    }
}
