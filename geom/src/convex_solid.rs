//! Convex solids on whose boundary curved surfaces lie.
//!
//! ```text
//! ball                        { y : |y − c| ≤ R }
//! outline, turned             { y : (|y⊥|, z) behind all its tangents } , z = (y − o)·â , y⊥ = y − o − z â
//! outline, moved along a line { y : its image along the line behind all tangents }
//! patch                       { y : behind all its tangent planes }
//! ```
//!
//! Cones and cylinders are turned lines. Each is a common part of half-spaces, and the surface lies in the
//! boundary of each of them. So all points between two points of such a solid belong to it, and lie on the
//! surface only where both do, in a plane that touches it: the surface hides nothing from anything within.

use glam::{DVec2, DVec3};

use crate::Motion;
use crate::outline::Outline;
use crate::tangent_planes::TangentPlanes;

/// A convex solid, without end where nothing bounds it: a cone and a cylinder go on beyond the surface that
/// lies on them.
#[derive(Clone, Debug)]
pub enum ConvexSolid {
    /// A ball.
    Ball {
        /// Its centre.
        center: DVec3,
        /// Its radius (length).
        radius: f64,
    },
    /// All within an outline that is turned about an axis.
    Turned {
        /// A point of the axis.
        origin: DVec3,
        /// Unit vector along the axis.
        axis: DVec3,
        /// The outline: distance from the axis, and height over the origin.
        outline: Outline,
    },
    /// All within an outline that is moved along a straight line.
    Moved {
        /// The origin of the outline's coordinates.
        origin: DVec3,
        /// Unit vectors along its coordinates.
        axes: [DVec3; 2],
        /// The outline.
        outline: Outline,
    },
    /// All behind all tangent planes of a patch.
    Patch(Box<TangentPlanes>),
}

impl ConvexSolid {
    /// Distance of a point from the boundary (length): above 0 outside, where it is no more than the distance
    /// from the solid, and convex. Of a patch it is weighted by the area element.
    pub fn excess(&self, point: DVec3) -> f64 {
        match self {
            Self::Ball { center, radius } => point.distance(*center) - radius,
            Self::Turned { origin, axis, outline } => {
                let offset = point - origin;
                let height = offset.dot(*axis);
                outline.excess(DVec2::new((offset - height * axis).length(), height))
            }
            Self::Moved { origin, axes, outline } => {
                outline.excess(DVec2::from_array(axes.map(|axis| axis.dot(point - origin))))
            }
            Self::Patch(planes) => planes.excess(point),
        }
    }

    /// The solid after a motion.
    pub(crate) fn moved(self, motion: &Motion) -> Self {
        match self {
            Self::Ball { center, radius } => {
                Self::Ball { center: motion.point(center), radius: motion.scale() * radius }
            }
            Self::Turned { origin, axis, outline } => Self::Turned {
                origin: motion.point(origin),
                axis: motion.direction(axis),
                outline: outline.scaled(motion.scale()),
            },
            Self::Moved { origin, axes, outline } => Self::Moved {
                origin: motion.point(origin),
                axes: axes.map(|axis| motion.direction(axis)),
                outline: outline.scaled(motion.scale()),
            },
            Self::Patch(planes) => Self::Patch(Box::new(planes.moved(motion))),
        }
    }
}
