//! The light of frames, in one of several ways.

use crate::scene::Scene;
use crate::solve::{Options, Progress};

use super::account::Account;
use super::course::Course;
use super::error::AnimationError;
use super::frame::Frame;
use super::sequence::Sequence;

/// How the light of one frame follows from that of others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// Not at all: each is solved by itself.
    Fresh,
    /// What has not changed since the frame before is kept ([`super::sequence`]).
    Selective,
    /// It is interpolated along the path ([`super::course`]).
    Path {
        /// Relative error that interpolation may have.
        tolerance: f64,
    },
}

/// The light of the frames of a scene.
#[derive(Debug)]
pub struct Follower<'a> {
    kind: Kind<'a>,
}

#[derive(Debug)]
enum Kind<'a> {
    /// By a sequence that keeps what has not changed, or nothing.
    Frames(Sequence<'a>),
    Path(Course<'a>),
}

impl<'a> Follower<'a> {
    /// For the frames `first` to `last` of `scene`, solved with `options`; nothing is solved yet.
    pub fn new(scene: &'a Scene, options: &Options, way: Way, frames: [usize; 2]) -> Self {
        let kind = match way {
            Way::Fresh => Kind::Frames(Sequence::fresh(scene, options)),
            Way::Selective => Kind::Frames(Sequence::new(scene, options)),
            Way::Path { tolerance } => {
                Kind::Path(Course::new(Sequence::new(scene, options), frames, tolerance))
            }
        };
        Self { kind }
    }

    /// The light of a frame, one of those that were asked for; `progress` may be called from any thread.
    ///
    /// # Errors
    /// As [`Sequence::at`].
    pub fn frame(
        &mut self,
        frame: usize,
        progress: &(dyn Fn(Progress) + Sync),
    ) -> Result<Frame, AnimationError> {
        match &mut self.kind {
            Kind::Frames(sequence) => sequence.at(frame as f64, progress),
            Kind::Path(course) => course.frame(frame, progress),
        }
    }

    /// What the moments that were solved so far cost, and what they miss.
    pub fn account(&self) -> &Account {
        match &self.kind {
            Kind::Frames(sequence) => sequence.account(),
            Kind::Path(course) => course.account(),
        }
    }

    /// Number of moments that were solved so far.
    pub fn solved(&self) -> usize {
        self.account().moments
    }

    /// Number of segments of the path so far, where light is interpolated.
    pub fn segments(&self) -> Option<usize> {
        match &self.kind {
            Kind::Path(course) => Some(course.segments()),
            _ => None,
        }
    }

    /// Largest relative error told of light that was interpolated so far.
    pub fn error(&self) -> Option<f64> {
        match &self.kind {
            Kind::Path(course) => course.error(),
            _ => None,
        }
    }
}
