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
    #[error("{}{failure}", frame(*moment))]
    Unsolved {
        /// The moment, in frames; None where the movers were placed by hand.
        moment: Option<f64>,
        /// Failure of the solution of that moment.
        failure: Box<Failure>,
    },
}

fn frame(moment: Option<f64>) -> String {
    moment.map_or_else(String::new, |moment| format!("frame {moment}: "))
}

impl AnimationError {
    /// The error of a moment (frames).
    pub(super) fn of(moment: impl Into<Option<f64>>, failure: Failure) -> Self {
        Self::Unsolved { moment: moment.into(), failure: Box::new(failure) }
    }
}
