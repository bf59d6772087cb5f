//! Why a frame could not be solved.

use radiosity_scene::SceneError;

use crate::driver::Failure;

/// Why a frame could not be solved.
#[derive(Debug, thiserror::Error)]
pub enum AnimationError {
    /// The scene of the frame cannot be.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// Series where rays carry the pairs.
    #[error("rays carry the pairs of this scene: series are for exact blocks")]
    ByRays,
    /// Direct light through masks, which are no polynomials.
    #[error(
        "light that goes through shadow masks cannot be interpolated along a path: follow it frame by frame"
    )]
    Masked,
    /// The light of a moment was not found.
    #[error("frame {moment}: {failure}")]
    Unsolved {
        /// The moment, in frames.
        moment: f64,
        /// Failure of the solution of that moment.
        failure: Box<Failure>,
    },
    /// The light of movers that were placed by hand was not found.
    #[error("{failure}")]
    UnsolvedByHand {
        /// Failure of the solution.
        failure: Box<Failure>,
    },
}

impl AnimationError {
    /// The error of a moment (frames), or of movers that were placed by hand.
    pub(super) fn of(moment: impl Into<Option<f64>>, failure: Failure) -> Self {
        let failure = Box::new(failure);
        match moment.into() {
            Some(moment) => Self::Unsolved { moment, failure },
            None => Self::UnsolvedByHand { failure },
        }
    }
}
