//! The light of frames, in one of several ways.

use crate::scene::Scene;
use crate::solve::{Options, Progress};

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
    solved: usize,
}

#[derive(Debug)]
enum Kind<'a> {
    Fresh(&'a Scene, Options),
    Selective(Sequence<'a>),
    Path(Course<'a>),
}

impl<'a> Follower<'a> {
    /// For the frames `first` to `last` of `scene`, solved with `options`; nothing is solved yet.
    pub fn new(scene: &'a Scene, options: &Options, way: Way, frames: [usize; 2]) -> Self {
        let kind = match way {
            Way::Fresh => Kind::Fresh(scene, *options),
            Way::Selective => Kind::Selective(Sequence::new(scene, options)),
            Way::Path { tolerance } => {
                Kind::Path(Course::new(Sequence::new(scene, options), frames, tolerance))
            }
        };
        Self { kind, solved: 0 }
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
        let solved = match &mut self.kind {
            Kind::Fresh(scene, options) => Sequence::new(scene, options).at(frame as f64, progress)?,
            Kind::Selective(sequence) => sequence.at(frame as f64, progress)?,
            Kind::Path(course) => {
                let now = course.frame(frame, progress)?;
                self.solved = course.solved();
                return Ok(now);
            }
        };
        self.solved += 1;
        Ok(Frame::of(solved))
    }

    /// Number of moments that were solved so far.
    pub fn solved(&self) -> usize {
        self.solved
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
