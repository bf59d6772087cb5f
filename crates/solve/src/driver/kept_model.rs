//! What is kept of a model for the next scene, in which some things have moved or changed.

use radiosity_transport::{KeptBlocks, StandingRays};

use super::sampling::Sampling;

/// Scenes after which the error that rays leave is estimated anew. It changes as slowly as the scene; to
/// estimate it takes two solutions.
const SCENES_EACH: usize = 16;

/// Blocks and rays of the scene before.
#[derive(Debug, Default)]
pub(crate) struct KeptModel {
    pub blocks: KeptBlocks,
    /// Rays that stand, where frames follow each other; None where each has the rays of a scene alone.
    pub standing: Option<Standing>,
}

/// Rays that stand from scene to scene, with what they were last found to be worth.
#[derive(Debug, Default)]
pub(crate) struct Standing {
    pub rays: StandingRays,
    told: Option<Sampling>,
    /// Scenes since it was told.
    since: usize,
}

impl Standing {
    /// The error that rays leave and their number, as told not long ago; None where it is to be estimated.
    pub(super) fn told(&mut self) -> Option<Sampling> {
        self.since += 1;
        self.told.filter(|_| self.since < SCENES_EACH)
    }

    /// Tells what the rays are worth.
    pub(super) fn tell(&mut self, sampling: Sampling) {
        *self = Self { told: Some(sampling), since: 0, rays: std::mem::take(&mut self.rays) };
    }
}
