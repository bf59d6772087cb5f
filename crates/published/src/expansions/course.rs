//! The line or the axis along which a pair moves.

use radiosity_geom::{DVec3, Motion};

use crate::series::RelativeMotion;

/// Angles below this are rounding: places follow from corners that were rounded, some of them of slivers.
const ROUNDED_ANGLE: f64 = 1e-10;

/// A motion along which a pair was seen to move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Course {
    /// Where the emitter is at p = 0.
    pub start: Motion,
    /// Length of p: a length, or an angle.
    pub motion: RelativeMotion,
}

impl Course {
    /// The course from one place of the emitter to another, p > 0 there; None where nothing moves.
    pub(super) fn between(start: &Motion, end: &Motion) -> Option<Self> {
        let step = start.inverse().then(end);
        let shift = step.point(DVec3::ZERO);
        let turn = Turn::of(&step);
        let motion = if turn.angle() <= ROUNDED_ANGLE {
            RelativeMotion::Translation(shift.try_normalize()?)
        } else {
            let axis = turn.sine.try_normalize()?;
            let centre = 0.5 * (shift + axis.cross(shift) / (0.5 * turn.angle()).tan());
            RelativeMotion::Rotation { axis, centre }
        };
        Some(Self { start: *start, motion })
    }

    /// The p of a place of the emitter, of which these are points; None where it is `aside` of the course by
    /// more than this length.
    pub(super) fn parameter(&self, place: &Motion, points: &[DVec3], aside: f64) -> Option<f64> {
        let step = self.start.inverse().then(place);
        let turn = Turn::of(&step);
        let p = match self.motion {
            RelativeMotion::Translation(direction) => step.point(DVec3::ZERO).dot(direction),
            RelativeMotion::Rotation { axis, .. } => turn.sine.dot(axis).atan2(turn.cosine),
        };
        let there = self.start.then(&self.motion.place(p));
        let is_on = |y: &DVec3| place.point(*y).distance(there.point(*y)) <= aside;
        points.iter().all(is_on).then_some(p)
    }
}

/// The rotation of a motion.
struct Turn {
    /// The axis, of the length sin θ.
    sine: DVec3,
    /// cos θ.
    cosine: f64,
}

impl Turn {
    fn of(motion: &Motion) -> Self {
        let [x, y, z] = DVec3::AXES.map(|axis| motion.direction(axis));
        let sine = 0.5 * DVec3::new(y.z - z.y, z.x - x.z, x.y - y.x);
        Self { sine, cosine: 0.5 * (x.x + y.y + z.z - 1.0) }
    }

    /// θ (radians), from 0 to half a turn.
    fn angle(&self) -> f64 {
        self.sine.length().atan2(self.cosine)
    }
}
