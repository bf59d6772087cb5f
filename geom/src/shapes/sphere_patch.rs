//! One sixth of a sphere, without a pole: X(u, v) = c + R p/|p|, p = n + tan(¼π u) e + tan(¼π v) f, with e ×
//! f = n.
//!
//! The equiangular cube sphere (Ronchi, Iacono, Paolucci, *The "cubed sphere"*, 1996): the six patches meet
//! edge to edge at equal parameters. Front: outside. Area ⅔ π R². Area element (¼π)² R² (1 + a²)(1 + b²)/(1 +
//! a² + b²)^{3/2}, a, b the tangents: between 0.70 and 1 times its value in the middle.

use super::sphere::meet;
use super::{check_finite, check_positive};
use crate::{Aabb, ConvexSolid, Hit, Jet, Ray, Rect, ShapeError, Surface};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_4, PI};

/// A curved square on a sphere, as wide as the face of the inscribed cube.
#[derive(Clone, Debug)]
pub struct SpherePatch {
    center: DVec3,
    radius: f64,
    /// e, f, n.
    axes: [DVec3; 3],
}

impl SpherePatch {
    /// The six patches of the sphere about `center`, in the order +x, −x, +y, −y, +z, −z.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, a radius not above zero.
    pub fn cube(center: DVec3, radius: f64) -> Result<[SpherePatch; 6], ShapeError> {
        check_finite("center", center)?;
        check_positive("radius", radius)?;
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        Ok(std::array::from_fn(|k| {
            let (e, f, n) = (axes[(k / 2 + 1) % 3], axes[(k / 2 + 2) % 3], axes[k / 2]);
            // Turning over e keeps the three right-handed on the opposite face.
            let axes = if k % 2 == 0 { [e, f, n] } else { [-e, f, -n] };
            SpherePatch { center, radius, axes }
        }))
    }

    fn point(&self, u: f64, v: f64) -> DVec3 {
        let [e, f, n] = self.axes;
        let p = n + (FRAC_PI_4 * u).tan() * e + (FRAC_PI_4 * v).tan() * f;
        self.center + self.radius * p.normalize()
    }
}

impl Surface for SpherePatch {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let [e, f, n] = self.axes;
        let (a, b) = ((FRAC_PI_4 * u).tan(), (FRAC_PI_4 * v).tan());
        let p = n + a * e + b * f;
        let length = p.length();
        let normal = p / length;
        // d(p/|p|) = (dp − (dp · p̂) p̂)/|p|, dp = ¼π (1 + a²) e.
        let tangent = |slope: f64, d: DVec3| {
            let speed = self.radius * FRAC_PI_4 * (1.0 + slope * slope) / length;
            speed * (d - d.dot(normal) * normal)
        };
        let (du, dv) = (tangent(a, e), tangent(b, f));
        Jet { position: self.center + self.radius * normal, du, dv, normal, area: du.cross(dv).length() }
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        let mut bounds = Aabb::around(rect.corners().map(|[u, v]| self.point(u, v)));
        // Sides are arcs of great circles and the inside bulges: a coordinate's extreme is at a corner, on a
        // side, or at the pole of that coordinate. Adding the extreme points of each that fall into the
        // rectangle makes the box exact.
        for k in 0..3 {
            for sign in [-1.0, 1.0] {
                let mut axis = DVec3::ZERO;
                axis[k] = sign;
                for [u, v] in self.extremes(axis, rect).into_iter().flatten() {
                    bounds = bounds.grow(self.point(u, v));
                }
            }
        }
        bounds
    }

    fn solid(&self) -> Option<ConvexSolid> {
        Some(ConvexSolid::Ball { center: self.center, radius: self.radius })
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        meet(self.center, self.radius, ray).into_iter().find_map(|t| {
            let [x, y, z] = self.axes.map(|axis| (ray.at(t) - self.center).dot(axis));
            (z > 0.0).then(|| Hit::accept(ray, t, x.atan2(z) / FRAC_PI_4, y.atan2(z) / FRAC_PI_4))?
        })
    }

    fn area(&self) -> f64 {
        2.0 / 3.0 * PI * self.radius * self.radius
    }
}

impl SpherePatch {
    /// Where on `rect` the coordinate along `axis` may be largest, besides the corners: inside, and on each
    /// side.
    fn extremes(&self, axis: DVec3, rect: &Rect) -> [Option<[f64; 2]>; 5] {
        let [x, y, z] = self.axes.map(|e| e.dot(axis));
        let angle = |y: f64, x: f64| y.atan2(x) / FRAC_PI_4;
        let within = |at: [f64; 2]| rect.contains(at[0], at[1]).then_some(at);
        // On the side of fixed u the point runs in the plane of f and m = (n + a e)/√(1 + a²), at angle tan β
        // = b/√(1 + a²).
        let side = |w: f64, along: f64, across: f64| {
            let a = (FRAC_PI_4 * w).tan();
            let tangent = along * (1.0 + a * a) / (z + a * across);
            tangent.atan() / FRAC_PI_4
        };
        [
            if z > 0.0 { within([angle(x, z), angle(y, z)]) } else { None },
            within([rect.u[0], side(rect.u[0], y, x)]),
            within([rect.u[1], side(rect.u[1], y, x)]),
            within([side(rect.v[0], x, y), rect.v[0]]),
            within([side(rect.v[1], x, y), rect.v[1]]),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_patches_close_the_sphere() {
        let patches = SpherePatch::cube(DVec3::ONE, 2.0).unwrap();
        let area: f64 = patches.iter().map(Surface::area).sum();
        assert!((area - 16.0 * PI).abs() < 1e-13 * area);
        let corners = patches.iter().flat_map(|p| Rect::FULL.corners().map(|[u, v]| p.jet(u, v).position));
        assert!(
            corners
                .into_iter()
                .all(|x| ((x - DVec3::ONE).abs() - 2.0 / 3.0_f64.sqrt()).abs().max_element() < 1e-15)
        );
    }

    #[test]
    fn errors_name_the_field() {
        assert_eq!(SpherePatch::cube(DVec3::ZERO, 0.0).unwrap_err().field(), "radius");
        assert_eq!(SpherePatch::cube(DVec3::NAN, 1.0).unwrap_err().field(), "center");
    }
}
