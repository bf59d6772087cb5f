//! Outlines of surfaces, which tell beforehand whether two of them can see each other.

use radiosity_geom::{COINCIDENT, DVec3, PlanarRegion, Rect};
use radiosity_scene::SceneSurface;

/// The outline of a surface.
pub(super) struct Outline {
    /// A point, the unit normal and the tolerance of its plane, if it is flat.
    plane: Option<(DVec3, DVec3, f64)>,
    /// Points whose convex hull contains it.
    pub(super) hull: Vec<DVec3>,
}

impl Outline {
    /// The outline of a surface.
    pub(super) fn of(surface: &SceneSurface) -> Self {
        let shape = &surface.shape;
        let plane = |region: &PlanarRegion| {
            (region.origin(), shape.jet(0.0, 0.0).normal, COINCIDENT * region.extent())
        };
        Self { plane: shape.region().map(plane), hull: shape.hull(&Rect::FULL) }
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
        self.plane.is_none_or(|(origin, normal, tolerance)| {
            other.hull.iter().any(|point| (*point - origin).dot(normal) > tolerance)
        })
    }
}
