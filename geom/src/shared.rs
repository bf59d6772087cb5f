//! A surface shared by several holders is a surface.

use crate::{Aabb, Foot, Hit, Jet, PlanarRegion, Ray, Rect, Surface};
use glam::DVec3;
use std::sync::Arc;

/// Every method is handed on, so that what a shape knows in closed form stays in use.
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

    fn region(&self) -> Option<&PlanarRegion> {
        (**self).region()
    }

    fn jets(&self, at: &[[f64; 2]], out: &mut [Jet]) {
        (**self).jets(at, out);
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
