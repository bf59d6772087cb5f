//! Surfaces moved: x ↦ σ R x + τ.
//!
//! Such a motion maps tangents by σ R, normals by R, areas by σ². A ray is carried back and the base is hit
//! where the moved surface is: t stays the same, since the direction is carried back unnormalised.

use crate::{
    Aabb, ConvexSolid, Foot, Hit, Jet, Meridian, Motion, PlanarRegion, Ray, Rect, ShapeError, Surface,
    TangentPlanes,
};
use glam::DVec3;

/// The surface `base` after a motion; parameters and front go with it.
#[derive(Debug)]
pub struct Placed {
    base: Box<dyn Surface>,
    motion: Motion,
    region: Option<PlanarRegion>,
}

impl Placed {
    /// Moves `base` by `motion`.
    pub fn new(base: Box<dyn Surface>, motion: Motion) -> Placed {
        let region = base.region().map(|region| region.moved(&motion));
        Placed { base, motion, region }
    }

    fn ray_back(&self, ray: &Ray) -> Ray {
        let (origin, direction) =
            (self.motion.point_back(ray.origin), self.motion.vector_back(ray.direction));
        Ray { origin, direction, range: ray.range }
    }

    fn jet_forth(&self, jet: Jet) -> Jet {
        Jet {
            position: self.motion.point(jet.position),
            du: self.motion.vector(jet.du),
            dv: self.motion.vector(jet.dv),
            normal: self.motion.direction(jet.normal),
            area: self.motion.scale().powi(2) * jet.area,
        }
    }
}

impl Surface for Placed {
    fn jet(&self, u: f64, v: f64) -> Jet {
        self.jet_forth(self.base.jet(u, v))
    }

    /// The boxes of 4 × 4 parts, moved: a moved box is wider than the box of what is in it, the less so the
    /// smaller it is.
    fn bounds(&self, rect: &Rect) -> Aabb {
        let parts = rect.quarters().into_iter().flat_map(|quarter| quarter.quarters());
        let corners = parts.flat_map(|part| self.base.bounds(&part).corners());
        Aabb::around(corners.map(|x| self.motion.point(x)))
    }

    fn hull(&self, rect: &Rect) -> Vec<DVec3> {
        self.base.hull(rect).into_iter().map(|x| self.motion.point(x)).collect()
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.base.intersect(&self.ray_back(ray))
    }

    fn ball(&self) -> Option<(DVec3, f64)> {
        self.base.ball().map(|(center, radius)| (self.motion.point(center), self.motion.scale() * radius))
    }

    fn meridian(&self) -> Option<Meridian> {
        self.base.meridian().map(|meridian| meridian.moved(&self.motion))
    }

    fn solid(&self) -> Option<ConvexSolid> {
        self.base.solid().map(|solid| solid.moved(&self.motion))
    }

    fn tangent_planes(&self) -> Option<TangentPlanes> {
        self.base.tangent_planes().map(|planes| planes.moved(&self.motion))
    }

    fn region(&self) -> Option<&PlanarRegion> {
        self.region.as_ref()
    }

    fn corners(&self) -> Vec<DVec3> {
        self.base.corners().into_iter().map(|x| self.motion.point(x)).collect()
    }

    /// The base with its corners moved themselves, so that they are exactly where `place` puts them.
    fn with_corners(&self, place: &dyn Fn(DVec3) -> DVec3) -> Option<Result<Box<dyn Surface>, ShapeError>> {
        self.base.with_corners(&|x| place(self.motion.point(x)))
    }

    fn occludes(&self, ray: &Ray) -> bool {
        self.base.occludes(&self.ray_back(ray))
    }

    fn area(&self) -> f64 {
        self.motion.scale().powi(2) * self.base.area()
    }

    fn project(&self, point: DVec3) -> Foot {
        let foot = self.base.project(self.motion.point_back(point));
        Foot { distance: self.motion.scale() * foot.distance, ..foot }
    }
}
