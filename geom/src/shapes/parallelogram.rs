//! Parallelogram: X(u, v) = o + ½(1 + u) e₁ + ½(1 + v) e₂.
//!
//! Front e₁ × e₂. Area |e₁ × e₂|, area element a quarter of it. Range: any two edges that span a plane.

use super::Bilinear;
use super::affine::Affine;
use super::{check_edge, check_finite};
use crate::tolerances::PARALLEL_DIRECTIONS;
use crate::{Aabb, Foot, Hit, Jet, PlanarRegion, Ray, Rect, ShapeError, Surface};
use glam::DVec3;

/// A flat four-sided patch with opposite sides parallel.
#[derive(Clone, Debug)]
pub struct Parallelogram {
    map: Affine,
    region: PlanarRegion,
}

impl Parallelogram {
    /// The parallelogram with a corner at `origin` (u = v = −1) and edges `edge1` (along u) and `edge2`
    /// (along v).
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, an edge of no length, parallel edges.
    pub fn new(origin: DVec3, edge1: DVec3, edge2: DVec3) -> Result<Parallelogram, ShapeError> {
        check_finite("origin", origin)?;
        check_edge("edge1", edge1)?;
        check_edge("edge2", edge2)?;
        if edge1.cross(edge2).length() <= PARALLEL_DIRECTIONS * edge1.length() * edge2.length() {
            return Err(ShapeError::Parallel { field: "edge2".into(), other: "edge1".into() });
        }
        let corners = vec![origin, origin + edge1, origin + edge1 + edge2, origin + edge2];
        let region = PlanarRegion::new(corners, vec![])?;
        let map = Affine::new(origin + 0.5 * (edge1 + edge2), 0.5 * edge1, 0.5 * edge2);
        Ok(Parallelogram { map, region })
    }
}

impl Surface for Parallelogram {
    fn jet(&self, u: f64, v: f64) -> Jet {
        self.map.jet(u, v)
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        self.map.bounds(rect)
    }

    fn hull(&self, rect: &Rect) -> Vec<DVec3> {
        rect.corners().map(|[u, v]| self.map.point(u, v)).to_vec()
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let Hit { t, u, v } = self.map.meet(ray)?;
        Hit::accept(ray, t, u, v)
    }

    fn region(&self) -> Option<&PlanarRegion> {
        Some(&self.region)
    }

    fn corners(&self) -> Vec<DVec3> {
        self.region.corners()
    }

    /// A quadrilateral of straight sides: moved one by one, the corners need not make a parallelogram.
    fn with_corners(&self, place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        let vertices = std::array::from_fn(|k| place(self.region.outer()[k]));
        Some(Bilinear::new(vertices).map(|moved| Box::new(moved) as Box<dyn Surface>))
    }

    fn project(&self, point: DVec3) -> Foot {
        self.map.nearest(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_name_the_edge() {
        let new = |a, b| Parallelogram::new(DVec3::ZERO, a, b).unwrap_err();
        assert_eq!(new(DVec3::ZERO, DVec3::X), ShapeError::ZeroLength { field: "edge1".into() });
        assert_eq!(new(DVec3::X, 2.0 * DVec3::X).field(), "edge2");
        assert_eq!(new(DVec3::X, DVec3::NAN), ShapeError::NotFinite { field: "edge2".into() });
    }

    #[test]
    fn corners_and_area() {
        let (e, f) = (DVec3::new(2.0, 0.0, 0.0), DVec3::new(1.0, 3.0, 0.0));
        let shape = Parallelogram::new(DVec3::Z, e, f).unwrap();
        assert_eq!(shape.jet(1.0, -1.0).position, DVec3::Z + e);
        assert_eq!(shape.jet(0.0, 0.0).normal, DVec3::Z);
        assert_eq!(shape.area(), 6.0);
        assert_eq!(shape.region().unwrap().convex_pieces().len(), 1);
    }
}
