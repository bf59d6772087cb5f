//! Parts of a model that are kept for the next scene, in which some things have moved or changed.

use radiosity_kernel::Blocks;
use radiosity_transport::{KeptBlocks, StandingRays};

use super::light_shares::LightShares;
use super::sampling::Sampling;

/// Scenes after which the error that rays leave is estimated anew. It changes as slowly as the scene; to
/// estimate it takes two solutions.
const SCENES_EACH: usize = 16;

/// Growth of the share of an emitter in all light from which on rays are spread anew, and from which on their
/// error is estimated anew. Chosen: rays of an element are as its share in part only.
const GROWN: f64 = 2.0;
const CHANGED: f64 = 1.1;

/// Growth of the error of rays from which on they are spread anew: what is bright has changed. Chosen: the
/// estimate itself is off by a third or so.
const WORSE: f64 = 2.0;

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
    /// elsewhere, and the same surfaces send light. Rays of a scene alone are spread by its light, and are sent
    /// anew; those that stand are where `shares` are others.
    pub(super) fn unchanged(
        &mut self,
        senders: &[bool],
        shares: &dyn Fn() -> LightShares,
    ) -> Option<(Blocks, Option<Sampling>)> {
        let WholeBlocks { blocks, sampling, senders: before } = self.whole.take()?;
        let fits = |standing: &Standing| {
            let shares = shares();
            standing.fit(&shares) && standing.holds(&shares)
        };
        let is_alike = before == senders && (sampling.is_none() || self.standing.as_ref().is_some_and(fits));
        let rays = sampling.map_or(0, |sampling| sampling.rays);
        (is_alike && self.blocks.is_unchanged(rays)).then_some((blocks, sampling))
    }

    /// Keeps all blocks for the next scene.
    pub(super) fn keep(&mut self, whole: WholeBlocks) {
        self.whole = Some(whole);
    }
}

/// Rays that stand from scene to scene, with what they were spread for, and last found to be worth.
#[derive(Debug, Default)]
pub(crate) struct Standing {
    pub rays: StandingRays,
    spread: Option<Worth>,
    told: Option<Worth>,
    /// Scenes since it was told.
    since: usize,
}

/// The error that rays leave, with the light for which it was found.
#[derive(Clone, Debug)]
struct Worth {
    sampling: Sampling,
    shares: LightShares,
}

impl Standing {
    /// Whether the rays were spread for light like this.
    pub(super) fn fit(&self, shares: &LightShares) -> bool {
        self.spread.as_ref().is_some_and(|spread| !shares.exceed(&spread.shares, GROWN))
    }

    /// Whether the error that was told last holds for this light.
    fn holds(&self, shares: &LightShares) -> bool {
        self.told.as_ref().is_some_and(|told| !shares.exceed(&told.shares, CHANGED))
    }

    /// The error that rays leave and their number, as told not long ago for light like this; None where it is
    /// to be estimated.
    pub(super) fn told(&mut self, shares: &LightShares) -> Option<Sampling> {
        self.since += 1;
        let holds = self.since < SCENES_EACH && self.holds(shares);
        self.told.as_ref().filter(|_| holds).map(|told| told.sampling)
    }

    /// Takes what the rays are worth in this light; whether that is about as much as when they were spread.
    pub(super) fn tell(&mut self, sampling: Sampling, shares: LightShares) -> bool {
        self.told = Some(Worth { sampling, shares });
        self.since = 0;
        let error = |worth: &Worth| worth.sampling.error.unwrap_or(f64::INFINITY);
        let spread = self.spread.as_ref().map_or(f64::INFINITY, error);
        sampling.error.unwrap_or(f64::INFINITY) <= WORSE * spread
    }

    /// Takes note that rays were spread for the light that was told last.
    pub(super) fn note_spread(&mut self) {
        self.spread.clone_from(&self.told);
    }
}
