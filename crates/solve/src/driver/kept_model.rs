//! Parts of a model that are kept for the next scene, in which some things have moved or changed.

use radiosity_kernel::Blocks;
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
    /// All blocks of the scene before.
    whole: Option<WholeBlocks>,
}

/// All blocks of a scene.
#[derive(Debug)]
pub(super) struct WholeBlocks {
    pub blocks: Blocks,
    pub sampling: Option<Sampling>,
    /// Whether each surface sends light: pairs that do not have no block.
    pub senders: Vec<bool>,
}

impl KeptModel {
    /// Kept parts of which none is there yet, beside these blocks; with rays that stand or without.
    pub(crate) fn beside(blocks: KeptBlocks, standing: Option<Standing>) -> Self {
        Self { blocks, standing, whole: None }
    }

    /// All blocks of the scene before, where they are those of this one, to which it was moved: nothing is
    /// elsewhere, and the same surfaces send light. Rays of a scene alone are chosen by its light, and are
    /// sent anew.
    pub(super) fn unchanged(&mut self, senders: &[bool]) -> Option<(Blocks, Option<Sampling>)> {
        let WholeBlocks { blocks, sampling, senders: before } = self.whole.take()?;
        let is_alike = before == senders && (sampling.is_none() || self.standing.is_some());
        let rays = sampling.map_or(0, |sampling| sampling.rays);
        (is_alike && self.blocks.is_unchanged(rays)).then_some((blocks, sampling))
    }

    /// Keeps all blocks for the next scene.
    pub(super) fn keep(&mut self, whole: WholeBlocks) {
        self.whole = Some(whole);
    }
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
