//! Frames solved one after the other, each as it would be alone.
//!
//! Nothing is known of the path: any frame may follow any other. What has not moved keeps its blocks (`src/transport/memory.rs`);
//! what has is integrated again, and so are the pairs between which it came or went. The solution of a frame does not depend on the
//! frames before it, not in a bit, so nothing can drift. Whether rays or exact blocks carry the pairs is decided once, for the
//! scene at rest; rays are sent anew for every frame.

use crate::scene::Scene;
use crate::solve::{Choice, Failure, Model, Options, Progress};
use crate::solved::Solved;
use crate::transport::Memory;

use super::error::AnimationError;

/// The frames of a scene that moves.
#[derive(Debug)]
pub struct Sequence<'a> {
    scene: &'a Scene,
    options: Options,
    /// What carries the pairs in all frames: rays or exact blocks.
    choice: Choice,
    memory: Memory,
}

impl<'a> Sequence<'a> {
    /// The frames of `scene`, all solved with the same options.
    pub fn new(scene: &'a Scene, options: &Options) -> Self {
        let choice = Choice::of(scene, options);
        Self { scene, options: *options, choice, memory: Memory::default() }
    }

    /// The scene with its motions.
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// The options that every frame is solved with.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The solution at a moment, a real number of frames; `progress` may be called from any thread.
    ///
    /// # Errors
    /// As [`Scene::at_moment`] and [`solve`](crate::solve::solve).
    pub fn at(
        &mut self,
        moment: f64,
        progress: &(dyn Fn(Progress) + Sync),
    ) -> Result<Solved, AnimationError> {
        let still = self.scene.at_moment(moment)?;
        let failed = |failure: Failure| AnimationError::of(moment, failure);
        let model = Model::assemble_again(&still, &self.options, &self.choice, &mut self.memory, progress)
            .map_err(failed)?;
        let outcome = model.solve(&still, progress).map_err(failed)?;
        Ok(Solved::of(still, self.options, outcome, None))
    }

    /// Blocks that were integrated for the last frame.
    pub fn integrated(&self) -> usize {
        self.memory.integrated()
    }

    /// Blocks that the last frame has in common with the one before.
    pub fn recalled(&self) -> usize {
        self.memory.recalled()
    }
}
