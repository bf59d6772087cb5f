//! A point that receives light from one side.

use std::f64::consts::PI;

use radiosity_elements::patch::Node;
use radiosity_geom::{DVec3, ROUNDING, clip_polygon};
use radiosity_kernel::irradiance::visible_polygon::visible_irradiance;
use radiosity_visibility::shadow_volume::ShadowVolume;

use crate::occluders::Site;

/// A point and normal for which light is gathered, with the surface under it.
#[derive(Clone, Copy, Debug)]
pub struct ReceiverPoint {
    /// The point.
    pub position: DVec3,
    /// Unit normal of the receiver, to which the cosines of E refer.
    pub normal: DVec3,
    /// Unit normal of the surface under the point if it differs from `normal`; nothing is seen through the
    /// surface.
    pub ground: Option<DVec3>,
    /// Index of the surface under the point, if any.
    pub surface: Option<usize>,
}

impl ReceiverPoint {
    /// A point in the open.
    pub fn free(position: DVec3, normal: DVec3) -> Self {
        Self { position, normal, ground: None, surface: None }
    }

    /// A point of a surface that receives along the surface's own normal.
    pub fn on(surface: usize, position: DVec3, normal: DVec3) -> Self {
        Self { position, normal, ground: None, surface: Some(surface) }
    }

    /// The point as a site of its own.
    pub fn site(&self) -> Site<'_> {
        let points = std::slice::from_ref(&self.position);
        Site { points, horizon: Some(self.ground.unwrap_or(self.normal)), surface: self.surface }
    }

    /// Whether the convex hull of `points` lies wholly below a horizon.
    pub(crate) fn is_above(&self, points: &[DVec3]) -> bool {
        let below = |horizon: DVec3| points.iter().all(|y| self.height(*y, horizon) <= 0.0);
        below(self.normal) || self.ground.is_some_and(below)
    }

    /// Whether all `points` lie above all horizons.
    pub(crate) fn overlooks(&self, points: &[DVec3]) -> bool {
        let above = |horizon: DVec3| points.iter().all(|y| self.height(*y, horizon) >= 0.0);
        above(self.normal) && self.ground.is_none_or(above)
    }

    /// Whether a ball lies wholly above all horizons.
    pub(crate) fn clears(&self, center: DVec3, radius: f64) -> bool {
        let above = |horizon: DVec3| (center - self.position).dot(horizon) > radius;
        above(self.normal) && self.ground.is_none_or(above)
    }

    /// Irradiance from the part of a planar convex polygon of exitance 1 outside the shadow volumes
    /// `volumes`.
    pub fn factor<'a>(&self, polygon: &[DVec3], volumes: impl Iterator<Item = &'a ShadowVolume>) -> f64 {
        match self.ground {
            None => visible_irradiance(self.position, self.normal, polygon, volumes),
            Some(ground) => {
                let above = clip_polygon(polygon, self.position, ground);
                visible_irradiance(self.position, self.normal, &above, volumes)
            }
        }
    }

    /// κ = cos θ cos θ' / (π d²) (1 / scene length²) to a point of a surface; None below a horizon or behind
    /// the surface.
    pub fn kernel_to(&self, node: &Node) -> Option<f64> {
        let step = node.position - self.position;
        let cosines = [self.normal.dot(step), -node.normal.dot(step)];
        let is_below = self.ground.is_some_and(|ground| ground.dot(step) <= 0.0);
        let is_seen = !is_below && cosines.iter().all(|cosine| *cosine > 0.0);
        is_seen.then(|| cosines[0] * cosines[1] / (PI * step.length_squared().powi(2)))
    }

    /// Height of `y` above a horizon; zero within rounding.
    fn height(&self, y: DVec3, horizon: DVec3) -> f64 {
        let offset = y - self.position;
        let height = offset.dot(horizon);
        if height * height <= ROUNDING * ROUNDING * offset.length_squared() { 0.0 } else { height }
    }
}
