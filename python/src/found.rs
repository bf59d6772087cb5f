//! Where light was found, and how it is read there.

use std::sync::Arc;

use radiosity::reading::checked_readings::CheckEffort;
use radiosity::reading::own_error::OwnError;
use radiosity::reading::quality::ReadSettings;
use radiosity::reading::run_cost::seconds_to_read;
use radiosity::request::{CheckRequest, MethodRequest, ReadRequest};
use radiosity::scene;
use radiosity::solve::Options;
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::solution;
use radiosity::solve::solved::Solved;
use radiosity::visibility::Visibility;

/// Where light was found.
pub(crate) enum Found {
    /// In a scene by itself, or in a file.
    Solved { solved: Arc<Solved>, is_saved: bool },
    /// In a frame.
    Frame(Box<Frame>),
}

impl Found {
    pub(crate) fn scene(&self) -> &scene::Scene {
        match self {
            Self::Solved { solved, .. } => &solved.scene,
            Self::Frame(frame) => &frame.scene,
        }
    }

    pub(crate) fn solution(&self) -> &solution::Solution {
        match self {
            Self::Solved { solved, .. } => &solved.outcome.solution,
            Self::Frame(frame) => &frame.solution,
        }
    }

    pub(crate) fn visibility(&self) -> &Visibility {
        match self {
            Self::Solved { solved, .. } => solved.visibility(),
            Self::Frame(frame) => &frame.visibility,
        }
    }

    pub(crate) fn reading(&self, request: &ReadRequest, method: &MethodRequest) -> ReadSettings {
        match self {
            Self::Solved { solved, is_saved } => request.reading(method, solved, *is_saved),
            Self::Frame(_) => request.plain(method),
        }
    }

    /// Own estimates of errors of what is read so of light with these options.
    pub(crate) fn own_error(&self, options: &Options, how: &ReadSettings) -> OwnError {
        match self {
            Self::Solved { solved, .. } => OwnError::of(solved, how),
            Self::Frame(frame) => OwnError::of_frame(frame, options, how),
        }
    }

    /// How much is checked of so many numbers that are read so and tell their errors; None where a referee
    /// does not know such light. Frames, which follow each other faster than a referee looks, are checked
    /// where that is asked for.
    pub(crate) fn effort(
        &self,
        check: &CheckRequest,
        options: &Options,
        how: &ReadSettings,
        count: usize,
    ) -> Option<CheckEffort> {
        match self {
            Self::Solved { solved, is_saved } => {
                let seconds = seconds_to_read(solved, how, count as f64);
                check.of_solution(solved, *is_saved, seconds, count)
            }
            // Seconds that are asked for do not follow from those of the run.
            Self::Frame(frame) => check.audit.and_then(|_| check.of_light(0.0, count, &frame.scene, options)),
        }
    }
}
