//! A surface turned over: same points, same parameters, front and back exchanged.

use crate::{
    Aabb, ConvexSolid, Foot, Hit, Jet, Meridian, PlanarRegion, Ray, Rect, ShapeError, Surface, TangentPlanes,
};
use glam::DVec3;

/// The surface `base` with its normal reversed. Parameters and tangents stay, so that here the normal is −x_u
/// × x_v.
#[derive(Debug)]
pub struct Flipped {
    base: Box<dyn Surface>,
    region: Option<PlanarRegion>,
}

impl Flipped {
    /// Turns `base` over.
    pub fn new(base: Box<dyn Surface>) -> Flipped {
        let region = base.region().map(PlanarRegion::flipped);
        Flipped { base, region }
    }
}

impl Surface for Flipped {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let jet = self.base.jet(u, v);
        Jet { normal: -jet.normal, ..jet }
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        self.base.bounds(rect)
    }

    fn hull(&self, rect: &Rect) -> Vec<DVec3> {
        self.base.hull(rect)
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.base.intersect(ray)
    }

    fn ball(&self) -> Option<(DVec3, f64)> {
        self.base.ball()
    }

    fn meridian(&self) -> Option<Meridian> {
        self.base.meridian().map(Meridian::flipped)
    }

    fn solid(&self) -> Option<ConvexSolid> {
        self.base.solid()
    }

    fn tangent_planes(&self) -> Option<TangentPlanes> {
        self.base.tangent_planes()
    }

    fn region(&self) -> Option<&PlanarRegion> {
        self.region.as_ref()
    }

    fn corners(&self) -> Vec<DVec3> {
        self.base.corners()
    }

    fn with_corners(&self, place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        let base = self.base.with_corners(place)?;
        Some(base.map(|base| Box::new(Flipped::new(base)) as Box<dyn Surface>))
    }

    fn occludes(&self, ray: &Ray) -> bool {
        self.base.occludes(ray)
    }

    fn area(&self) -> f64 {
        self.base.area()
    }

    fn project(&self, point: DVec3) -> Foot {
        self.base.project(point)
    }
}
