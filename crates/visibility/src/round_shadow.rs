//! The shadow of a ball, a can, a cone or a disk from a point, by its outline.

use radiosity_geom::DVec3;

use crate::frustum::Frustum;
use crate::round_outline::RoundOutline;
use crate::shadow_cone::ShadowCone;
use crate::shadow_volume::Corners;

/// The shadow of something round from a point.
#[derive(Debug)]
pub struct RoundShadow<'a> {
    /// The outline, relative to the point.
    pub outline: RoundOutline,
    body: Body<'a>,
}

/// The thing that throws a shadow.
#[derive(Debug)]
enum Body<'a> {
    Ball(ShadowCone),
    Frustum { eye: DVec3, frustum: &'a Frustum },
}

impl<'a> RoundShadow<'a> {
    pub(crate) fn of_ball(cone: ShadowCone) -> Self {
        Self { outline: cone.outline(), body: Body::Ball(cone) }
    }

    /// The shadow of a frustum from `eye`; None where `eye` is not outside.
    pub fn of_frustum(frustum: &'a Frustum, eye: DVec3) -> Option<Self> {
        Some(Self { outline: frustum.outline(eye)?, body: Body::Frustum { eye, frustum } })
    }

    /// Cuts off the part of a polygon, relative to the point, before the thing.
    pub fn cut(&self, polygon: &mut Corners) {
        if let Body::Ball(cone) = &self.body {
            cone.cut(polygon);
        }
    }

    /// The part of a convex polygon, relative to the point, within kites of so many `corners` on a full turn that
    /// stand for the outline.
    pub fn kites(&self, polygon: &[DVec3], corners: usize) -> Corners {
        let pyramid = self.outline.pyramid(DVec3::ZERO, corners);
        pyramid.map_or_else(Corners::new, |pyramid| pyramid.hidden_part(polygon))
    }

    /// Whether a direction lies within the outline.
    pub fn holds(&self, direction: DVec3) -> bool {
        match &self.body {
            Body::Ball(cone) => cone.holds(direction),
            Body::Frustum { eye, frustum } => frustum.is_met(*eye, direction),
        }
    }
}
