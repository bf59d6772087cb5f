//! A triangle and a ray.

use radiosity_geom::{DVec3, Ray};

/// Where a ray meets a triangle, in lengths of its direction: Möller and Trumbore, 1997.
#[inline]
pub fn hit_triangle([p, q, r]: &[DVec3; 3], ray: &Ray) -> Option<f64> {
    let (e, f) = (*q - *p, *r - *p);
    let across = ray.direction.cross(f);
    let scale = 1.0 / e.dot(across);
    let from = ray.origin - *p;
    let a = scale * from.dot(across);
    let turned = from.cross(e);
    let b = scale * ray.direction.dot(turned);
    let t = scale * f.dot(turned);
    (a >= 0.0 && b >= 0.0 && a + b <= 1.0 && ray.reaches(t)).then_some(t)
}
