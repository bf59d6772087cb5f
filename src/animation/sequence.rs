//! Frames solved one after the other, each as it would be alone.
//!
//! Nothing is known of the path: any frame may follow any other. What has not moved keeps its blocks, and rays that nothing has
//! come into the way of meet what they met (`src/transport/memory.rs`); what has is integrated and traced again, and so are the
//! pairs between which it came or went. The solution of a frame does not depend on the frames before it, not in a bit, so nothing
//! can drift. Whether rays or exact blocks carry the pairs, and how surfaces are cut, is decided once, for the scene at rest.

use crate::scene::{Scene, Stills};
use crate::solve::{Failure, Layout, Model, Options, Progress};
use crate::transport::{Memory, RayCounts};

use super::account::Account;
use super::error::AnimationError;
use super::frame::Frame;

/// The frames of a scene that moves.
#[derive(Debug)]
pub struct Sequence<'a> {
    stills: Stills<'a>,
    options: Options,
    layout: Layout,
    /// What is known of the frame before; None where nothing is kept.
    memory: Option<Memory>,
    account: Account,
}

impl<'a> Sequence<'a> {
    /// The frames of `scene`, all solved with the same options.
    pub fn new(scene: &'a Scene, options: &Options) -> Self {
        Self { memory: Some(Memory::default()), ..Self::fresh(scene, options) }
    }

    /// The same to the bit, with nothing kept between frames.
    pub fn fresh(scene: &'a Scene, options: &Options) -> Self {
        Self {
            stills: Stills::of(scene),
            options: *options,
            layout: Layout::of(scene, options),
            memory: None,
            account: Account::default(),
        }
    }

    /// The scene with its motions.
    pub fn scene(&self) -> &'a Scene {
        self.stills.scene()
    }

    /// The options that every frame is solved with.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The light at a moment, a real number of frames; `progress` may be called from any thread.
    ///
    /// # Errors
    /// As [`Scene::at_moment`] and [`solve`](crate::solve::solve).
    pub fn at(&mut self, moment: f64, progress: &(dyn Fn(Progress) + Sync)) -> Result<Frame, AnimationError> {
        let still = self.stills.at(moment)?;
        let failed = |failure: Failure| AnimationError::of(moment, failure);
        let memory = self.memory.as_mut();
        let model =
            Model::assemble_again(&still, &self.options, &self.layout, memory, progress).map_err(failed)?;
        let outcome = model.solve(&still, progress).map_err(failed)?;
        let traced =
            || RayCounts { traced: outcome.sampling.map_or(0, |sampling| sampling.rays), recalled: 0 };
        let rays = self.memory.as_ref().map_or_else(traced, Memory::rays);
        self.account.take(&still, &outcome, rays);
        Ok(Frame::of(still, model.into_visibility(), outcome))
    }

    /// What all moments so far cost, and what they miss.
    pub fn account(&self) -> &Account {
        &self.account
    }

    /// Blocks that were integrated for the last frame.
    pub fn integrated(&self) -> usize {
        self.memory.as_ref().map_or(0, Memory::integrated)
    }

    /// Blocks that the last frame has in common with the one before.
    pub fn recalled(&self) -> usize {
        self.memory.as_ref().map_or(0, Memory::recalled)
    }
}
