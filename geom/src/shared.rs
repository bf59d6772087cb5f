//! A surface shared by several holders is a surface.

use crate::{
    Aabb, ConvexSolid, Foot, Hit, Jet, Meridian, PlanarRegion, Ray, Rect, ShapeError, Surface, TangentPlanes,
};
use glam::DVec3;
use std::sync::Arc;

/// Every method is forwarded, so that a shape's closed forms stay in use.
impl<S: Surface + ?Sized> Surface for Arc<S> {
    fn jet(&self, u: f64, v: f64) -> Jet {
        (**self).jet(u, v)
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        (**self).bounds(rect)
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        (**self).intersect(ray)
    }

    fn hull(&self, rect: &Rect) -> Vec<DVec3> {
        (**self).hull(rect)
    }

    fn ball(&self) -> Option<(DVec3, f64)> {
        (**self).ball()
    }

    fn meridian(&self) -> Option<Meridian> {
        (**self).meridian()
    }

    fn tangent_planes(&self) -> Option<TangentPlanes> {
        (**self).tangent_planes()
    }

    fn solid(&self) -> Option<ConvexSolid> {
        (**self).solid()
    }

    fn region(&self) -> Option<&PlanarRegion> {
        (**self).region()
    }

    fn corners(&self) -> Vec<DVec3> {
        (**self).corners()
    }

    fn with_corners(&self, place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        (**self).with_corners(place)
    }

    fn occludes(&self, ray: &Ray) -> bool {
        (**self).occludes(ray)
    }

    fn area(&self) -> f64 {
        (**self).area()
    }

    fn project(&self, point: DVec3) -> Foot {
        (**self).project(point)
    }

    fn invert(&self, point: DVec3) -> Option<[f64; 2]> {
        (**self).invert(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{FULL_TURN, Parallelogram, Sphere};

    /// By default the trait gives None, no corners, and boxes for hulls.
    #[test]
    fn shapes_are_known_through_the_arc() {
        let ball = Sphere::new(DVec3::X, 2.0, DVec3::Z, [-2.0, 2.0], FULL_TURN).unwrap();
        let square = Parallelogram::new(DVec3::ZERO, DVec3::X + DVec3::Y, DVec3::Z).unwrap();
        let shared: Arc<dyn Surface> = Arc::new(Arc::new(ball));
        assert_eq!(shared.ball(), Some((DVec3::X, 2.0)));
        let shared: Arc<dyn Surface> = Arc::new(Arc::new(square.clone()));
        assert!(shared.region().is_some());
        assert_eq!(shared.hull(&Rect::FULL), square.hull(&Rect::FULL));
    }
}
