//! Planar polygon with holes, kept whole: X(u, v) = m + u a + v b, where [−1, 1]² is the outline's smallest
//! rectangle.
//!
//! A smallest enclosing rectangle has a side along an edge of the convex hull (Freeman and Shapira,
//! *Determining the minimum-area encasing rectangle*, CACM 18, 1975); all hull edges are tried, the earliest
//! of equals is taken. Front by the right-hand rule of the outline. Area by Newell's formula, less the holes.

use super::affine::Affine;
use crate::hull::convex_hull;
use crate::{Aabb, Foot, Hit, Jet, PlanarRegion, Ray, Rect, ShapeError, Surface};
use glam::{DVec2, DVec3};

/// A polygon in a plane, with or without holes.
#[derive(Clone, Debug)]
pub struct Polygon {
    map: Affine,
    region: PlanarRegion,
}

impl Polygon {
    /// The polygon inside `outer` and outside all `holes`.
    ///
    /// # Errors
    ///
    /// As [`PlanarRegion::new`].
    pub fn new(outer: Vec<DVec3>, holes: Vec<Vec<DVec3>>) -> Result<Polygon, ShapeError> {
        let region = PlanarRegion::new(outer, holes)?;
        let map = smallest_rectangle(&region);
        Ok(Polygon { map, region })
    }
}

impl Surface for Polygon {
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
        let hit = Hit::accept(ray, t, u, v)?;
        self.region.covers(self.region.to_plane(ray.at(t))).then_some(hit)
    }

    fn region(&self) -> Option<&PlanarRegion> {
        Some(&self.region)
    }

    fn corners(&self) -> Vec<DVec3> {
        self.region.corners()
    }

    fn with_corners(&self, place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        let ring = |ring: &[DVec3]| ring.iter().map(|x| place(*x)).collect();
        let holes = self.region.holes().iter().map(|hole| ring(hole)).collect();
        let moved = Polygon::new(ring(self.region.outer()), holes);
        Some(moved.map(|moved| Box::new(moved) as Box<dyn Surface>))
    }

    fn project(&self, point: DVec3) -> Foot {
        self.map.nearest(point)
    }
}

/// The affine map of [−1, 1]² onto the outline's smallest rectangle, with the region's normal.
fn smallest_rectangle(region: &PlanarRegion) -> Affine {
    let hull = convex_hull(region.flat_outline());
    let edges = hull.iter().zip(hull.iter().cycle().skip(1));
    let boxes = edges.map(|(p, q)| rectangle_along(&hull, (*q - *p).normalize()));
    let area = |own: &Rectangle| own.du.length() * own.dv.length();
    let first = |best: Rectangle, next: Rectangle| {
        if area(&next) < (1.0 - 1e-12) * area(&best) { next } else { best }
    };
    let Rectangle { center, du, dv } = boxes.reduce(first).expect("a hull has edges");
    let [x, y] = region.axes();
    let vector = |w: DVec2| w.x * x + w.y * y;
    Affine::new(region.origin() + vector(center), vector(du), vector(dv))
}

/// A rectangle in a plane, given by its centre and its half axes.
struct Rectangle {
    center: DVec2,
    du: DVec2,
    dv: DVec2,
}

/// The rectangle around `hull` with a side along the unit vector `along`.
fn rectangle_along(hull: &[DVec2], along: DVec2) -> Rectangle {
    let across = along.perp();
    let range = |axis: DVec2| {
        let reach = hull.iter().map(|p| p.dot(axis));
        (reach.clone().fold(f64::INFINITY, f64::min), reach.fold(f64::NEG_INFINITY, f64::max))
    };
    let ((u0, u1), (v0, v1)) = (range(along), range(across));
    let center = 0.5 * ((u0 + u1) * along + (v0 + v1) * across);
    Rectangle { center, du: 0.5 * (u1 - u0) * along, dv: 0.5 * (v1 - v0) * across }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn l_shape() -> Vec<DVec3> {
        [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
            .map(|(x, y)| DVec3::new(x, y, 3.0))
            .to_vec()
    }

    #[test]
    fn the_parameter_square_is_the_bounding_rectangle() {
        let shape = Polygon::new(l_shape(), vec![]).unwrap();
        assert!(shape.jet(-1.0, -1.0).position.distance(DVec3::new(0.0, 0.0, 3.0)) < 1e-15);
        assert!(shape.jet(1.0, 1.0).position.distance(DVec3::new(2.0, 2.0, 3.0)) < 1e-15);
        assert_eq!(shape.area(), 3.0);
        assert_eq!(shape.jet(0.0, 0.0).normal, DVec3::Z);
    }

    #[test]
    fn rays_pass_through_holes_and_notches() {
        let hole =
            [(0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8)].map(|(x, y)| DVec3::new(x, y, 3.0)).to_vec();
        let shape = Polygon::new(l_shape(), vec![hole]).unwrap();
        let hit = |x, y| shape.occludes(&Ray::new(DVec3::new(x, y, 0.0), DVec3::Z));
        assert!(hit(1.5, 0.5) && hit(0.1, 0.1) && hit(0.2, 0.5) && hit(1.0, 1.5));
        assert!(!hit(0.5, 0.5) && !hit(1.5, 1.5) && !hit(-0.1, 0.5));
    }
}
