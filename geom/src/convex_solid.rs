//! Convex solids on whose boundary curved surfaces lie: balls, cones and cylinders.
//!
//! ```text
//! ball   { y : |y − c| ≤ R }
//! cone   { y : |y⊥| ≤ R + k z } ,   z = (y − o)·â ,   y⊥ = y − o − z â      (cylinder: k = 0)
//! ```
//!
//! All points between two points of such a solid belong to it, and to its boundary only where both do. So a
//! wall on the boundary hides nothing from anything within.

use glam::DVec3;

use crate::Motion;

/// A convex solid without end: a cone and a cylinder go on beyond the surface that lies on them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ConvexSolid {
    /// A ball.
    Ball {
        /// Its centre.
        center: DVec3,
        /// Its radius (length).
        radius: f64,
    },
    /// A cone, or a cylinder.
    Cone {
        /// A point of the axis.
        origin: DVec3,
        /// Unit vector along the axis.
        axis: DVec3,
        /// Radius at the origin (length).
        radius: f64,
        /// Growth of the radius along the axis.
        slope: f64,
    },
}

impl ConvexSolid {
    /// Distance of a point from the boundary (length): above 0 outside, where it is no more than the distance
    /// from the solid, and convex.
    pub fn excess(&self, point: DVec3) -> f64 {
        match *self {
            Self::Ball { center, radius } => point.distance(center) - radius,
            Self::Cone { origin, axis, radius, slope } => {
                let offset = point - origin;
                let height = offset.dot(axis);
                let across = (offset - height * axis).length();
                (across - radius - slope * height) / (1.0 + slope * slope).sqrt()
            }
        }
    }

    /// The solid after a motion.
    pub(crate) fn moved(self, motion: &Motion) -> Self {
        match self {
            Self::Ball { center, radius } => {
                Self::Ball { center: motion.point(center), radius: motion.scale() * radius }
            }
            Self::Cone { origin, axis, radius, slope } => Self::Cone {
                origin: motion.point(origin),
                axis: motion.direction(axis),
                radius: motion.scale() * radius,
                slope,
            },
        }
    }
}
