//! Rigid paths: translations and rotations of a thing from its place at rest, by time.

use radiosity_geom::{DQuat, DVec3};

use crate::{
    fault::Fault,
    pose::Pose,
    ranges::check_number,
    time_function::{TimeFunction, Times},
};

/// A rigid path: first a rotation about a point, then a translation, each from the pose at rest, whatever
/// came before.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPath {
    shift: Option<TimeFunction<DVec3>>,
    turn: Option<Turn>,
}

/// A rotation about an axis, right-handed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisAngle {
    /// Vector along the axis, of any length.
    pub axis: DVec3,
    /// Angle (degrees).
    pub degrees: f64,
}

/// Rotations about a point by time.
#[derive(Clone, Debug, PartialEq)]
pub struct Turn {
    center: DVec3,
    kind: TurnForm,
}

#[derive(Clone, Debug, PartialEq)]
enum TurnForm {
    /// Rotations about one unit axis, by degrees over time.
    Axis(DVec3, TimeFunction<f64>),
    /// Rotations, and between them the shorter way about one axis at constant speed.
    Keys(Times, Vec<DQuat>),
}

impl RigidPath {
    /// The path of what stays at rest.
    pub const REST: Self = Self { shift: None, turn: None };

    /// The path along a track (scene length), without rotation.
    pub fn along(shift: TimeFunction<DVec3>) -> Self {
        Self { shift: Some(shift), turn: None }
    }

    /// The path of rotations about a point, without translation.
    pub fn turning(turn: Turn) -> Self {
        Self { shift: None, turn: Some(turn) }
    }

    /// The path of rotations about a point, each followed by a translation along a track (scene length).
    pub fn turning_along(turn: Turn, shift: TimeFunction<DVec3>) -> Self {
        Self { shift: Some(shift), turn: Some(turn) }
    }

    /// Whether nothing moves along the path.
    pub(crate) fn is_rest(&self) -> bool {
        *self == Self::REST
    }

    /// The times at which the path may bend: it is smooth between them, and rests before the first and after
    /// the last.
    pub(crate) fn times(&self) -> Vec<f64> {
        let shift = self.shift.iter().flat_map(TimeFunction::times).copied();
        let turn = self.turn.iter().flat_map(|turn| match &turn.kind {
            TurnForm::Axis(_, degrees) => degrees.times(),
            TurnForm::Keys(times, _) => times.all(),
        });
        shift.chain(turn.copied()).collect()
    }

    /// The pose at a time; equal times have equal poses, to the bit.
    pub fn pose(&self, time: f64) -> Pose {
        let shift = self.shift.as_ref().map_or(DVec3::ZERO, |shift| shift.at(time));
        match &self.turn {
            None => Pose::turned(DVec3::ZERO, DQuat::IDENTITY, shift),
            Some(turn) => Pose::turned(turn.center, turn.rotation(time), shift),
        }
    }

    /// The path after `middle` was subtracted from all coordinates.
    pub(super) fn about(self, middle: DVec3) -> Self {
        let turn = self.turn.map(|turn| Turn { center: turn.center - middle, ..turn });
        Self { turn, ..self }
    }
}

fn no_axis() -> Fault {
    Fault::no_direction("axis", "give the direction of the axis, e.g. [0, 0, 1]")
}

impl Turn {
    /// Rotations about the axis through `center` along `axis` of any length, by the degrees of a track,
    /// right-handed.
    ///
    /// # Errors
    /// [`FaultKind::NoDirection`](crate::FaultKind::NoDirection) for an axis without a length; a number that
    /// is not finite or out of range.
    pub fn about_axis(center: DVec3, axis: DVec3, degrees: TimeFunction<f64>) -> Result<Self, Fault> {
        [center, axis].into_iter().try_for_each(check_point)?;
        let axis = axis.try_normalize().ok_or_else(no_axis)?;
        Ok(Self { center, kind: TurnForm::Axis(axis, degrees) })
    }

    /// Rotations about `center`: one of `rotations` at each of the `times`, which ascend, and between them
    /// the shorter way about one axis at constant speed.
    ///
    /// # Errors
    /// [`FaultKind::NoDirection`](crate::FaultKind::NoDirection) for degrees about an axis without a length;
    /// a number that is not finite or out of range; what [`TimeFunction::new`] refuses.
    pub fn by_keys(center: DVec3, rotations: &[AxisAngle], times: Vec<f64>) -> Result<Self, Fault> {
        let times = Times::new(times, "turns", rotations.len())?;
        check_point(center)?;
        let key = |AxisAngle { axis, degrees }: &AxisAngle| {
            check_point(*axis)?;
            check_number(*degrees)?;
            match axis.try_normalize() {
                Some(axis) => Ok(rotation(axis, *degrees)),
                None if *degrees == 0.0 => Ok(DQuat::IDENTITY),
                None => Err(no_axis()),
            }
        };
        let keys = rotations.iter().map(key).collect::<Result<_, _>>()?;
        Ok(Self { center, kind: TurnForm::Keys(times, keys) })
    }

    fn rotation(&self, time: f64) -> DQuat {
        match &self.kind {
            TurnForm::Axis(axis, degrees) => rotation(*axis, degrees.at(time)),
            TurnForm::Keys(times, keys) => match times.place(time) {
                // Keys are met to the bit.
                (before, 0.0) => keys[before],
                (before, 1.0) => keys[before + 1],
                (before, s) => keys[before].slerp(keys[before + 1], s).normalize(),
            },
        }
    }
}

/// Rotation by degrees about a unit axis; whole turns are the identity, to the bit.
fn rotation(axis: DVec3, degrees: f64) -> DQuat {
    DQuat::from_axis_angle(axis, (degrees % 360.0).to_radians())
}

fn check_point(x: DVec3) -> Result<(), Fault> {
    x.to_array().into_iter().try_for_each(check_number)
}
