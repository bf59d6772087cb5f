//! Outlines of surfaces, which tell beforehand whether two of them can see each other.

use radiosity_geom::{COINCIDENT, DVec3, PlanarRegion, Plane, Rect};
use radiosity_scene::SceneSurface;

/// The outline of a surface.
pub(super) struct Outline {
    /// Its plane, if it is flat.
    plane: Option<Plane>,
    /// Heights over its plane up to this one count as zero (scene length).
    tolerance: f64,
    /// Points whose convex hull contains it.
    pub(super) hull: Vec<DVec3>,
}

impl Outline {
    /// The outline of a surface.
    pub(super) fn of(surface: &SceneSurface) -> Self {
        let shape = &surface.shape;
        let plane =
            |region: &PlanarRegion| Plane { point: region.origin(), normal: shape.jet(0.0, 0.0).normal };
        Self {
            plane: shape.region().map(plane),
            tolerance: shape.region().map_or(0.0, |region| COINCIDENT * region.extent()),
            hull: shape.hull(&Rect::FULL),
        }
    }

    /// Whether the surface is flat.
    pub(super) fn is_flat(&self) -> bool {
        self.plane.is_some()
    }

    /// Whether neither surface lies wholly behind or in the plane of the other.
    pub(super) fn exchanges_with(&self, other: &Outline) -> bool {
        self.reaches_before(other) && other.reaches_before(self)
    }

    /// Whether some of `other` lies in front of the plane; true for a curved surface.
    fn reaches_before(&self, other: &Outline) -> bool {
        self.plane.is_none_or(|plane| other.hull.iter().any(|x| plane.height(*x) > self.tolerance))
    }
}
