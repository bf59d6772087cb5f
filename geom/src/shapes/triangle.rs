//! Triangle: X(u, v) = v₀ + ½(1 + u)(v₁ − v₀) + ½(1 + v)(v₂ − v₀), the half u + v ≤ 0 of a parallelogram.
//!
//! Front (v₁ − v₀) × (v₂ − v₀). Area ½ |(v₁ − v₀) × (v₂ − v₀)|. The other half of [−1, 1]² is not part of the
//! surface.

use super::affine::Affine;
use crate::{Aabb, Hit, Jet, PlanarRegion, Ray, Rect, ShapeError, Surface};
use glam::DVec3;

/// A flat three-sided patch.
#[derive(Clone, Debug)]
pub struct Triangle {
    map: Affine,
    region: PlanarRegion,
}

impl Triangle {
    /// The triangle with `vertices` at u, v = (−1, −1), (1, −1), (−1, 1).
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, coinciding vertices, vertices in a line.
    pub fn new(vertices: [DVec3; 3]) -> Result<Triangle, ShapeError> {
        let region = PlanarRegion::new(vertices.to_vec(), vec![])?;
        let [p, q, r] = vertices;
        let map = Affine::new(0.5 * (q + r), 0.5 * (q - p), 0.5 * (r - p));
        Ok(Triangle { map, region })
    }
}

impl Surface for Triangle {
    fn jet(&self, u: f64, v: f64) -> Jet {
        self.map.jet(u, v)
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        let outline = Aabb::around(self.region.outer().iter().copied());
        self.map.bounds(rect).intersection(outline)
    }

    fn hull(&self, rect: &Rect) -> Vec<DVec3> {
        rect.corners().map(|[u, v]| self.map.point(u, v)).to_vec()
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let Hit { t, u, v } = self.map.meet(ray)?;
        if u + v > Hit::SEAM { None } else { Hit::accept(ray, t, u, v) }
    }

    fn region(&self) -> Option<&PlanarRegion> {
        Some(&self.region)
    }

    fn corners(&self) -> Vec<DVec3> {
        self.region.corners()
    }

    fn with_corners(&self, place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        let vertices = std::array::from_fn(|k| place(self.region.outer()[k]));
        Some(Triangle::new(vertices).map(|moved| Box::new(moved) as Box<dyn Surface>))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_lower_half_is_hit() {
        let shape = Triangle::new([DVec3::ZERO, DVec3::X, DVec3::Y]).unwrap();
        let down = |x, y| shape.intersect(&Ray::new(DVec3::new(x, y, 1.0), -DVec3::Z));
        assert!(down(0.3, 0.3).is_some() && down(0.5, 0.5).is_some() && down(0.6, 0.6).is_none());
        assert_eq!(shape.area(), 0.5);
    }

    #[test]
    fn a_line_is_no_triangle() {
        let error = Triangle::new([DVec3::ZERO, DVec3::X, 2.0 * DVec3::X]).unwrap_err();
        assert_eq!(error.field(), "vertices");
    }
}
