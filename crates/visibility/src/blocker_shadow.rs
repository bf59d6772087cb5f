//! Shadow of a blocker from a point, by its kind of outline.

use radiosity_geom::DVec3;

use crate::bounding_ball::Ball;
use crate::shadow_cone::ShadowCone;
use crate::shadow_volume::{Corners, Coverage, ShadowVolume};

/// The shadow of a planar piece or a convex body, or of a ball, from a point.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "most shadows are pyramids, made at each point: none is boxed")]
pub enum BlockerShadow {
    /// Of planar pieces and bodies.
    Pyramid(ShadowVolume),
    /// Of a ball.
    Cone(ShadowCone),
}

impl BlockerShadow {
    /// The tip.
    pub fn eye(&self) -> DVec3 {
        match self {
            Self::Pyramid(volume) => volume.eye(),
            Self::Cone(cone) => cone.eye(),
        }
    }

    /// Whether a ball lies wholly outside.
    pub fn misses(&self, ball: &Ball) -> bool {
        match self {
            Self::Pyramid(volume) => volume.misses(ball),
            Self::Cone(cone) => cone.misses(ball),
        }
    }

    /// Position of the hull of `points`, relative to the tip and no farther from it than `reach`. What a cone
    /// does not cover counts as mixed.
    pub fn coverage_within(&self, points: &[DVec3], reach: f64) -> Coverage {
        match self {
            Self::Pyramid(volume) => volume.coverage_within(points, reach),
            Self::Cone(cone) if cone.covers(points) => Coverage::Hidden,
            Self::Cone(_) => Coverage::Mixed,
        }
    }

    /// The hidden part of a convex polygon, relative to the tip.
    pub fn hidden_part(&self, polygon: &[DVec3]) -> Corners {
        match self {
            Self::Pyramid(volume) => volume.hidden_part(polygon),
            Self::Cone(cone) => cone.hidden_part(polygon),
        }
    }

    /// Returns the hidden part of a convex polygon, relative to the tip, and adds the rest to `parts`.
    pub fn divide(&self, polygon: &[DVec3], parts: &mut Vec<Corners>) -> Corners {
        match self {
            Self::Pyramid(volume) => volume.divide(polygon, parts),
            Self::Cone(cone) => match cone.pyramid() {
                Some(pyramid) => pyramid.divide(polygon, parts),
                None => {
                    parts.push(Corners::from_slice(polygon));
                    Corners::new()
                }
            },
        }
    }
}
