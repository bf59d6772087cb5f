//! How the emitter of a pair moves relative to the receiver.

use radiosity_geom::{DQuat, DVec3, Motion};

use super::error::SeriesError;

/// Largest convergence of a rotation, tan(θ/2) of a quarter turn. Chosen: what lies farther is expanded anew.
const QUARTER: f64 = 1.0;

/// A translation along a line, or a rotation about an axis; p tells how far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RelativeMotion {
    /// By p times this displacement (scene length).
    Translation(DVec3),
    /// By the angle p (radians, right-handed).
    Rotation {
        /// Unit vector along the axis.
        axis: DVec3,
        /// A point of the axis.
        centre: DVec3,
    },
}

impl RelativeMotion {
    /// The motion with an axis of length 1.
    pub(super) fn checked(self) -> Result<Self, SeriesError> {
        match self {
            Self::Translation(direction) => {
                let length = direction.length();
                let is_some = length.is_finite() && length > 0.0;
                is_some.then_some(self).ok_or(SeriesError::Direction)
            }
            Self::Rotation { axis, centre } => {
                let axis = axis.try_normalize().filter(|_| centre.is_finite());
                axis.map(|axis| Self::Rotation { axis, centre }).ok_or(SeriesError::Direction)
            }
        }
    }

    /// Where what was at p = 0 is at p.
    pub fn place(&self, p: f64) -> Motion {
        match *self {
            Self::Translation(direction) => Motion::rigid(DQuat::IDENTITY, p * direction),
            Self::Rotation { axis, centre } => {
                let rotation = DQuat::from_axis_angle(axis, p);
                let turned = Motion::rigid(rotation, DVec3::ZERO).point(centre);
                Motion::rigid(rotation, centre - turned)
            }
        }
    }

    /// The variable t of the power series for a change of p: the change itself, or the tangent of half of an
    /// angle below a half turn.
    pub(super) fn variable(&self, step: f64) -> f64 {
        match self {
            Self::Translation(_) => step,
            Self::Rotation { .. } if step.abs() < core::f64::consts::PI => (0.5 * step).tan(),
            Self::Rotation { .. } => f64::INFINITY.copysign(step),
        }
    }

    /// The change of p for a value of the variable.
    pub(super) fn step(&self, variable: f64) -> f64 {
        match self {
            Self::Translation(_) => variable,
            Self::Rotation { .. } => 2.0 * variable.atan(),
        }
    }

    /// Degree of the numerator of the kernel in the variable.
    pub(super) fn degree(&self) -> usize {
        match self {
            Self::Translation(_) => 2,
            Self::Rotation { .. } => 4,
        }
    }

    /// The variable below which the series of all points of two polygons converge that are so far apart.
    ///
    /// For points at v and u from the axis, across it, |r(π)|² = r² + 4 v·u and |r(π)| ≤ r + 2 min(|v|, |u|)
    /// after a half turn; v·u is bilinear, so that its largest value is at corners.
    pub(super) fn convergence(&self, [receiver, emitter]: [&[DVec3]; 2], distance: f64) -> f64 {
        let (axis, centre) = match *self {
            Self::Translation(direction) => return distance / direction.length(),
            Self::Rotation { axis, centre } => (axis, centre),
        };
        let arms = |corners: &[DVec3]| -> Vec<DVec3> {
            corners.iter().map(|x| (x - centre).reject_from_normalized(axis)).collect()
        };
        let [receiver, emitter] = [arms(receiver), arms(emitter)];
        let longest = |arms: &[DVec3]| arms.iter().fold(0.0, |most: f64, arm| most.max(arm.length()));
        let products = receiver.iter().flat_map(|v| emitter.iter().map(move |u| v.dot(*u)));
        let product = products.fold(0.0, f64::max);
        let by_product = distance / (distance * distance + 4.0 * product).sqrt();
        let by_arm = distance / (distance + 2.0 * longest(&receiver).min(longest(&emitter)));
        by_product.max(by_arm).min(QUARTER)
    }
}
