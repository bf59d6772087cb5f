//! The light of frames, in one of several ways.

use radiosity_scene::Scene;
use radiosity_work::Work;

use crate::driver::Options;

use super::error::AnimationError;
use super::frame::Frame;
use super::path_interpolation::PathInterpolation;
use super::sequence::Sequence;
use super::sequence_report::SequenceReport;

/// Relative residual of frames between which light is interpolated, over the error that this may have.
/// Chosen: what is left unsolved is then taken for no bend of the light.
const OF_INTERPOLATION: f64 = 0.1;

/// Ways in which the light of one frame follows from that of others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FollowMode {
    /// No frame follows from others: each is solved by itself.
    Fresh,
    /// Blocks and rays that have not changed since the frame before are kept ([`super::sequence`]).
    Selective,
    /// As [`FollowMode::Selective`]; only the difference from the frame before is solved for, and rays stand
    /// ([`Sequence::incremental`]).
    Incremental,
    /// Light is interpolated along the path, by Chebyshev polynomials of time, where it is smooth; all other
    /// frames as by [`FollowMode::Incremental`].
    Path {
        /// Relative error that interpolation may have.
        tolerance: f64,
    },
    /// As [`FollowMode::Selective`]; blocks of what is translated or turns about an axis are sums of series
    /// ([`radiosity_published::series`]) as far as that pays, where exact blocks carry the pairs. Curved
    /// things, those on paths that bend, and pairs with something between, are integrated.
    Series {
        /// Error that a block may have, relative to its largest entry.
        tolerance: f64,
    },
}

/// The light of the frames of a scene.
#[derive(Debug)]
pub struct Follower<'a> {
    source: FrameSource<'a>,
    break_even: BreakEven,
    /// Largest error told of series so far.
    error: Option<f64>,
}

#[derive(Debug)]
enum FrameSource<'a> {
    /// Frames by a sequence that keeps what has not changed, or nothing.
    Frames(Sequence<'a>),
    Path(PathInterpolation<'a>),
}

impl<'a> Follower<'a> {
    /// The follower of the frames `first` to `last` of `scene`, solved with `options`; nothing is solved yet.
    pub fn new(scene: &'a Scene, options: &Options, mode: FollowMode, frames: [usize; 2]) -> Self {
        let source = match mode {
            FollowMode::Fresh => FrameSource::Frames(Sequence::fresh(scene, options)),
            FollowMode::Selective => FrameSource::Frames(Sequence::new(scene, options)),
            FollowMode::Incremental => FrameSource::Frames(Sequence::incremental(scene, options)),
            FollowMode::Series { tolerance } => {
                FrameSource::Frames(Sequence::by_series(scene, options, tolerance))
            }
            FollowMode::Path { tolerance } => {
                let sequence = Sequence::incremental_within(scene, options, OF_INTERPOLATION * tolerance);
                FrameSource::Path(PathInterpolation::new(sequence, frames, tolerance))
            }
        };
        Self { source, break_even: BreakEven::default(), error: None }
    }

    /// The light of a frame, one of those that were asked for.
    ///
    /// # Errors
    /// As [`Sequence::at`].
    pub fn frame(&mut self, frame: usize, work: &Work<'_>) -> Result<Frame, AnimationError> {
        let (now, spent) = match &mut self.source {
            FrameSource::Frames(sequence) => {
                let now = sequence.at(frame as f64, work)?;
                self.error = larger(self.error, now.interpolated);
                (now, sequence.spent())
            }
            FrameSource::Path(path) => (path.frame(frame, work)?, path.spent()),
        };
        self.break_even.add_frame(spent);
        Ok(now)
    }

    /// Cost and error of the moments that were solved so far.
    pub fn report(&self) -> &SequenceReport {
        match &self.source {
            FrameSource::Frames(sequence) => sequence.report(),
            FrameSource::Path(path) => path.report(),
        }
    }

    /// The number of frames after which the set-up was repaid, as far as frames were asked for: from then on
    /// all cost less, in blocks that were integrated or rays that were traced, than if each had been solved
    /// alone. None if they do not.
    pub fn repaid(&self) -> Option<usize> {
        self.break_even.repaid()
    }

    /// Number of moments that were solved so far.
    pub fn solved(&self) -> usize {
        self.report().moments
    }

    /// Whether something is set up that later frames repay: points of a path, or expansions.
    pub fn has_set_up(&self) -> bool {
        match &self.source {
            FrameSource::Frames(sequence) => sequence.has_series(),
            FrameSource::Path(_) => true,
        }
    }

    /// Number of segments of the path so far, where light is interpolated.
    pub fn segments(&self) -> Option<usize> {
        match &self.source {
            FrameSource::Path(path) => Some(path.segments()),
            _ => None,
        }
    }

    /// Largest relative error told of light that was interpolated so far, or that follows from series.
    pub fn error(&self) -> Option<f64> {
        match &self.source {
            FrameSource::Path(path) => path.error(),
            _ => self.error,
        }
    }
}

/// The larger one of two errors that are known.
fn larger(own: Option<f64>, other: Option<f64>) -> Option<f64> {
    own.into_iter().chain(other).reduce(f64::max)
}

/// Cost of frames, in solutions of a single frame that is solved alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct BreakEven {
    frames: usize,
    repaid: Option<usize>,
}

impl BreakEven {
    /// Takes note of a frame more, after all of them together cost `spent` solutions.
    fn add_frame(&mut self, spent: f64) {
        self.frames += 1;
        let is_repaid = spent < self.frames as f64;
        self.repaid = is_repaid.then(|| self.repaid.unwrap_or(self.frames));
    }

    /// The number of frames from which on all together cost less than if each were solved alone; None if they
    /// cost as much.
    fn repaid(&self) -> Option<usize> {
        self.repaid
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_repaid_and_lent_again_is_repaid_later() {
        let mut break_even = BreakEven::default();
        let repaid = [5.0, 5.0, 5.0, 5.0, 5.0, 5.0, 8.0, 8.0, 8.0].map(|spent| {
            break_even.add_frame(spent);
            break_even.repaid()
        });
        assert_eq!(repaid, [None, None, None, None, None, Some(6), None, None, Some(9)]);
    }
}
