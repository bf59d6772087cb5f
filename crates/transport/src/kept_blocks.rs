//! Blocks and hits of rays of a scene, kept for the next one, in which some things have moved.
//!
//! A block follows from its two elements, the surfaces that may stand between them, and the accuracy that the
//! other pairs of its rows leave to it. Where all these are as they were, to the bit, so is the block: it is
//! taken from there, and the matrix is the one that would be integrated anew. So it is with rays
//! ([`kept_rays`]). What did not move is found by comparing what is given, not by what somebody says has
//! moved.

mod change;
pub mod kept_rays;

use std::collections::HashMap;
use std::sync::Arc;

use radiosity_elements::Elements;
use radiosity_geom::{RayTree, Rect};
use radiosity_kernel::blocks::block::Block;
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::Ranks;
use serde::{Deserialize, Serialize};

use crate::known::KnownBlocks;
pub(crate) use change::SceneChange;
use change::SceneState;
use kept_rays::{ChangedSurfaces, ElementRays, MOST, RayCounts};
pub(crate) use kept_rays::{KeptHit, KeptRays};

/// Blocks and rays of earlier scenes. The scenes have the same surfaces in the same order, each here or
/// there, and are solved with the same options.
#[derive(Debug, Default)]
pub struct KeptBlocks {
    /// Number of the scene that was seen last, from 1.
    scenes: u64,
    state: Option<SceneState>,
    last_changes: LastChanges,
    blocks: HashMap<(u32, u32), KeptBlock>,
    /// Blocks that were integrated for the last scene, by all ranks.
    integrated: usize,
    /// Blocks that the last scene has in common with the one before.
    recalled: usize,
    /// Hits of the rays of each sequence.
    sequences: HashMap<usize, KeptSequence>,
    changed: Option<Arc<ChangedSurfaces>>,
    /// Differences of the last scene from the one before, if there was one of as many surfaces and elements.
    change: Option<Arc<SceneChange>>,
    ray_counts: RayCounts,
    /// Source of blocks that have changed, if there is one beside the rules.
    known: Option<Arc<dyn KnownBlocks>>,
}

/// The number of the scene in which each element and surface last changed.
#[derive(Debug, Default)]
struct LastChanges {
    elements: Vec<u64>,
    surfaces: Vec<u64>,
}

/// The rays of a sequence, by elements; of those that have changed since then there are none.
#[derive(Debug)]
struct KeptSequence {
    /// Number of the scene in which they were sent.
    scene: u64,
    elements: Vec<ElementRays>,
}

/// Differences of the last scene from the one before.
#[derive(Debug)]
pub(crate) struct LastChange {
    pub change: Arc<SceneChange>,
    pub changed: Arc<ChangedSurfaces>,
}

/// A block with what it was integrated for.
#[derive(Debug)]
struct KeptBlock {
    request: Request,
    /// Number of the scene for which it was integrated.
    scene: u64,
    block: Arc<IntegratedBlock>,
}

/// All that a block follows from beside its elements.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Request {
    pub row: u32,
    pub column: u32,
    /// Surfaces that may hide a part of the pair, and the other faces of the bodies that they close.
    pub surfaces: Vec<usize>,
    /// All numbers that say how accurate it has to be, as bits.
    pub numbers: Vec<u64>,
}

/// A block as it is kept.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct IntegratedBlock {
    pub block: Block,
    /// Bound of the norm of what it differs by from the integrated block, where it is known otherwise; else
    /// 0.
    pub remainder: f64,
}

impl IntegratedBlock {
    pub(crate) fn of(block: Block) -> Self {
        Self::known(block, 0.0)
    }

    pub(crate) fn known(block: Block, remainder: f64) -> Self {
        Self { block, remainder }
    }
}

impl KeptBlocks {
    /// No blocks and rays yet; blocks that have changed are asked of `known` before they are integrated.
    pub fn beside(known: Arc<dyn KnownBlocks>) -> Self {
        Self { known: Some(known), ..Self::default() }
    }

    /// Source of blocks that have changed, if there is one beside the rules.
    pub(crate) fn known(&self) -> Option<&dyn KnownBlocks> {
        self.known.as_deref()
    }

    /// Takes note of what differs in the next scene from the one before. Where the number of surfaces or
    /// elements is another, all is forgotten.
    pub fn move_to(&mut self, scene: &Scene, elements: &Arc<Elements>, visibility: &Visibility) {
        let state = SceneState::of(scene, elements, visibility);
        let change = self.state.as_ref().and_then(|before| state.change(before));
        let is_first = change.is_none();
        let change = change.unwrap_or_else(|| {
            let [elements, surfaces] = state.counts();
            let last_changes = LastChanges { elements: vec![1; elements], surfaces: vec![1; surfaces] };
            *self = Self { last_changes, known: self.known.take(), ..Self::default() };
            SceneChange {
                elements: vec![true; elements],
                surfaces: vec![true; surfaces],
                starts: vec![true; surfaces],
            }
        });
        self.known.iter().for_each(|known| known.move_to(elements.list()));
        self.forget_rays(&state, &change);
        self.scenes += 1;
        mark(&mut self.last_changes.elements, &change.elements, self.scenes);
        mark(&mut self.last_changes.surfaces, &change.surfaces, self.scenes);
        let marked = state.marked(&change.surfaces);
        self.changed = Some(Arc::new(ChangedSurfaces {
            surfaces: change.surfaces.clone(),
            boxes: marked.iter().map(|surface| surface.bounds(&Rect::FULL)).collect(),
            tree: RayTree::new(marked),
            reach: visibility.reach(),
        }));
        self.change = (!is_first).then(|| Arc::new(change));
        self.ray_counts = RayCounts::default();
        self.state = Some(state);
    }

    /// Differences of the last scene from the one before; None where that had other numbers of surfaces or
    /// elements, or there was none.
    pub(crate) fn last_change(&self) -> Option<LastChange> {
        Some(LastChange { change: self.change.clone()?, changed: self.changed.clone()? })
    }

    /// Whether nothing has changed in the last scene; then its blocks and rays are those of the one before,
    /// and count as recalled: `rays` of them.
    pub fn is_unchanged(&mut self, rays: u64) -> bool {
        let is_unchanged = self.change.as_ref().is_some_and(|change| change.is_none());
        if is_unchanged {
            (self.integrated, self.recalled) = (0, self.integrated + self.recalled);
            self.ray_counts = RayCounts { traced: 0, recalled: rays };
        }
        is_unchanged
    }

    /// The elements of the last scene.
    pub fn elements(&self) -> Option<&Elements> {
        self.state.as_ref().map(|state| state.elements.as_ref())
    }

    /// The elements of the last scene, shared.
    pub(crate) fn shared_elements(&self) -> Option<Arc<Elements>> {
        self.state.as_ref().map(|state| Arc::clone(&state.elements))
    }

    /// Forgets the rays that were not sent in the last scene, and those of elements that have changed since
    /// then.
    fn forget_rays(&mut self, state: &SceneState, change: &SceneChange) {
        self.sequences.retain(|_, sequence| sequence.scene == self.scenes);
        for sequence in self.sequences.values_mut() {
            for ((element, rays), owner) in sequence.elements.iter_mut().enumerate().zip(state.owners()) {
                if change.is_moved(element, owner) {
                    *rays = ElementRays::default();
                }
            }
        }
    }

    /// Takes out the kept rays of a sequence, one of so many, until [`KeptBlocks::put_rays`]: the rays of
    /// each element of this number.
    pub(crate) fn take_rays(
        &mut self,
        sequence: usize,
        sequences: usize,
        numbers: Vec<u64>,
        ranks: &Ranks,
    ) -> Option<KeptRays> {
        let changed = Arc::clone(self.changed.as_ref()?);
        let before = self.sequences.remove(&sequence).map(|kept| kept.elements).unwrap_or_default();
        let room = MOST / (sequences * ranks.count()) as u64;
        Some(KeptRays::new(before, &numbers, changed, room))
    }

    /// Keeps what the rays of a sequence met in this scene; all ranks together, each those that it sent.
    pub(crate) fn put_rays(&mut self, sequence: usize, rays: KeptRays, ranks: &Ranks) {
        let (elements, counts) = rays.into_rays();
        self.count_rays(counts, ranks);
        self.sequences.insert(sequence, KeptSequence { scene: self.scenes, elements });
    }

    /// Adds rays of this scene, those of each rank.
    pub(crate) fn count_rays(&mut self, RayCounts { traced, recalled }: RayCounts, ranks: &Ranks) {
        let sums = ranks.sums(vec![traced, recalled]);
        self.ray_counts.traced += sums[0];
        self.ray_counts.recalled += sums[1];
    }

    /// The block that answers a request, where nothing has changed since it was integrated.
    pub(crate) fn get(&self, request: &Request) -> Option<&Arc<IntegratedBlock>> {
        let kept = self.blocks.get(&(request.row, request.column))?;
        let LastChanges { elements, surfaces } = &self.last_changes;
        let ends = [request.row, request.column].map(|element| elements[element as usize]);
        let blockers = request.surfaces.iter().map(|surface| surfaces[*surface]);
        let is_valid = ends.into_iter().chain(blockers).all(|changed| changed <= kept.scene);
        (is_valid && kept.request == *request).then_some(&kept.block)
    }

    /// The block that answered the same request in the scene before, whatever has changed since.
    pub(crate) fn get_outdated(&self, request: &Request) -> Option<&Arc<IntegratedBlock>> {
        let kept = self.blocks.get(&(request.row, request.column))?;
        (kept.request == *request).then_some(&kept.block)
    }

    /// Samples of the block of the pair in the scene before, whatever was asked for.
    pub(crate) fn samples(&self, request: &Request) -> Option<u64> {
        let kept = self.blocks.get(&(request.row, request.column))?;
        Some(kept.block.block.report.samples)
    }

    /// Keeps the answers to the requests of this scene, and forgets all others; all ranks together, each
    /// those that it made.
    pub(crate) fn replace(&mut self, requested: Vec<(Request, Arc<IntegratedBlock>)>, ranks: &Ranks) {
        let mut blocks = HashMap::with_capacity(requested.len());
        let (mut integrated, mut recalled) = (0, 0);
        for (request, block) in requested {
            let before = self.blocks.get(&(request.row, request.column));
            let is_old = before.is_some_and(|kept| Arc::ptr_eq(&kept.block, &block));
            recalled += u64::from(is_old);
            integrated += u64::from(!is_old);
            let scene = before.filter(|_| is_old).map_or(self.scenes, |kept| kept.scene);
            blocks.insert((request.row, request.column), KeptBlock { request, scene, block });
        }
        self.blocks = blocks;
        let sums = ranks.sums(vec![integrated, recalled]);
        (self.integrated, self.recalled) = (sums[0] as usize, sums[1] as usize);
    }

    /// Blocks that had to be integrated for the last scene.
    pub fn integrated(&self) -> usize {
        self.integrated
    }

    /// Blocks that were the same as before.
    pub fn recalled(&self) -> usize {
        self.recalled
    }

    /// Rays that were sent for the last scene.
    pub fn ray_counts(&self) -> RayCounts {
        self.ray_counts
    }
}

/// Sets the marked places to this number.
fn mark(numbers: &mut [u64], marks: &[bool], number: u64) {
    numbers.iter_mut().zip(marks).filter(|(_, mark)| **mark).for_each(|(own, _)| *own = number);
}
