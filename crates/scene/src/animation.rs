//! Animations: frames, and movers that each follow a path, and may change what they emit.
//!
//! Frame k, counted from 0, shows the time k over the frames in a unit of time. A moment is a real number of
//! frames, from 0 to the last frame: also what is between two frames has a state.

use radiosity_geom::DVec3;

use crate::{
    emission_track::EmissionTrack,
    fault::{Fault, FaultKind, shown},
    mover_state::MoverState,
    path::RigidPath,
    place::Place,
    ranges::check_range,
};

/// Most frames: eleven hours at 25 a second. A larger number is a slip.
pub const MOST_FRAMES: usize = 1_000_000;

/// The frames of a scene and its movers.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Animation {
    /// Number of frames, at least 1.
    pub frames: usize,
    /// Frames in a unit of time, > 0; 1 where times count frames.
    pub rate: f64,
    /// Movers, each with its own path, in the order of the file.
    pub movers: Vec<Mover>,
}

/// Surfaces, luminaires and camera that move together along one path; what the surfaces and luminaires emit
/// may change alike.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Mover {
    /// Name, unique among the movers of the scene.
    pub name: String,
    /// Indices of its surfaces, ascending; no surface belongs to two movers.
    pub surfaces: Vec<usize>,
    /// Indices of its luminaires, ascending; no luminaire belongs to two movers.
    pub luminaires: Vec<usize>,
    /// Whether the camera moves along; at most one mover has it.
    pub camera: bool,
    /// Its path by time, in the coordinates that the scene is computed in.
    pub path: RigidPath,
    /// Factors on what its surfaces and luminaires emit, by time; none where that stays.
    pub emission: Option<EmissionTrack>,
    /// Its place in the file; none if it was made in code.
    pub place: Option<Place>,
}

/// Number of frames, and frames in a unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    frames: usize,
    rate: f64,
}

impl Clock {
    /// A clock of `frames` frames, of which `rate` show a unit of time.
    ///
    /// # Errors
    /// A number out of range or not finite.
    pub fn new(frames: usize, rate: f64) -> Result<Self, Fault> {
        check_frames(frames)?;
        check_rate(rate)?;
        Ok(Self { frames, rate })
    }

    /// Times from the first frame to the last, `count` of them at equal distances.
    pub fn spread(&self, count: usize) -> Vec<f64> {
        // A single frame is as long as one of two: paths need times that ascend.
        let last = (self.frames - 1).max(1) as f64 / self.rate;
        let steps = count.saturating_sub(1).max(1);
        (0..count).map(|k| if k == steps { last } else { last * (k as f64 / steps as f64) }).collect()
    }
}

impl Animation {
    pub(super) fn new(clock: Clock, movers: Vec<Mover>) -> Self {
        Self { frames: clock.frames, rate: clock.rate, movers }
    }

    /// The animation after `middle` was subtracted from all coordinates.
    pub fn about(mut self, middle: DVec3) -> Self {
        self.movers.iter_mut().for_each(|mover| mover.path = mover.path.clone().about(middle));
        self
    }

    /// The number of the mover of this name.
    ///
    /// # Errors
    /// [`FaultKind::UnknownName`] where there is none.
    pub fn mover(&self, name: &str) -> Result<usize, Fault> {
        let known = || self.movers.iter().map(|mover| mover.name.clone()).collect::<Vec<_>>();
        let found = self.movers.iter().position(|mover| mover.name == name);
        found.ok_or_else(|| {
            Fault::unknown_name(format!("unknown motion {name:?}"), name, known(), "motions of this scene")
        })
    }

    /// The moments at which a path, or what is emitted over time, may bend, ascending, in frames.
    pub fn bends(&self) -> Vec<f64> {
        let of_emission = |own: &Mover| own.emission.as_ref().map_or_else(Vec::new, EmissionTrack::times);
        let times = self.movers.iter().flat_map(|own| [own.path.times(), of_emission(own)].concat());
        let mut moments: Vec<f64> = times.map(|time| time * self.rate).collect();
        moments.sort_by(f64::total_cmp);
        moments.dedup();
        moments
    }

    /// The states of all movers at a moment.
    ///
    /// # Errors
    /// [`FaultKind::OutOfRange`] for a moment that is not from 0 to the last frame.
    pub fn states(&self, moment: f64) -> Result<Vec<MoverState>, Fault> {
        let last = self.frames - 1;
        if !(0.0..=last as f64).contains(&moment) {
            let cause = format!("there is no frame {}: frames are counted from 0 to {last}", shown(moment));
            return Err(Fault::new(FaultKind::OutOfRange, cause, format!("choose one from 0 to {last}")));
        }
        Ok(self.movers.iter().map(|mover| mover.state(moment / self.rate)).collect())
    }
}

impl Mover {
    /// Whether it moves at all, or what it emits alone changes.
    pub fn has_path(&self) -> bool {
        !self.path.is_rest()
    }

    /// Its state at a time.
    fn state(&self, time: f64) -> MoverState {
        let factors = self.emission.as_ref().map_or_else(Vec::new, |own| own.factors(time));
        MoverState { pose: self.path.pose(time), factors }
    }
}

/// Checks the number of frames, 1 to 10⁶.
pub fn check_frames(frames: usize) -> Result<(), Fault> {
    let inside = (1..=MOST_FRAMES).contains(&frames);
    check_range(frames as f64, inside, "the number of frames", "1 ≤ frames ≤ 1000000")
}

/// Checks the number of frames in a unit of time, 1e-6 to 1e6.
pub fn check_rate(rate: f64) -> Result<(), Fault> {
    check_range(rate, (1e-6..=1e6).contains(&rate), "the rate of frames", "1e-6 ≤ fps ≤ 1e6")
}

#[cfg(test)]
mod tests {
    use crate::time_function::{Curve, TimeFunction};

    use super::*;

    #[test]
    fn the_last_frame_shows_the_last_of_spread_times() {
        for (frames, rate) in [(2, 25.0), (7, 0.3), (100, 24.0), (13, 1.0)] {
            let clock = Clock::new(frames, rate).unwrap();
            let times = clock.spread(4);
            let values = [0.0, 1.0, -2.0, 3.0].map(|x| x * DVec3::X).to_vec();
            let path = RigidPath::along(TimeFunction::new("points", values, times, Curve::Line).unwrap());
            let mover = Mover {
                name: "a".into(),
                surfaces: vec![0],
                luminaires: Vec::new(),
                camera: false,
                path,
                emission: None,
                place: None,
            };
            let animation = Animation::new(clock, vec![mover]);
            let pose = |moment: f64| animation.states(moment).unwrap()[0].pose;
            assert!(pose(0.0).is_rest());
            assert_eq!(pose((frames - 1) as f64).point(DVec3::ZERO), 3.0 * DVec3::X);
            let last = format!("frames are counted from 0 to {}", frames - 1);
            for moment in [-1.0, f64::NAN, frames as f64] {
                let fault = animation.states(moment).unwrap_err();
                assert!(fault.kind == FaultKind::OutOfRange && fault.to_string().ends_with(&last), "{fault}");
            }
        }
    }
}
