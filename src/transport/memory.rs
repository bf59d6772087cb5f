//! Blocks that are kept from one scene to the next, in which some things have moved.
//!
//! A block follows from its two elements, the surfaces that may stand between them, and the accuracy that the other pairs of
//! its rows leave to it. Where all these are as they were, to the bit, so is the block: it is taken from memory, and the
//! matrix is the one that would be integrated anew. What did not move is found by comparing what is given, not by what
//! somebody says has moved.

use std::collections::HashMap;
use std::sync::{Arc, OnceLock};

use radiosity_geom::Surface;

use crate::elements::basis::AreaBasis;
use crate::elements::patch::Patch;
use crate::elements::{Element, Elements};
use crate::scene::Scene;
use crate::transport::blocks::block::Block;

/// Blocks of earlier scenes. The scenes have the same surfaces in the same order, each here or there, and are solved with the same options.
#[derive(Debug, Default)]
pub(crate) struct Memory {
    /// Number of the scene that was seen last, from 1.
    scenes: u64,
    elements: Vec<Piece>,
    surfaces: Vec<Arc<dyn Surface>>,
    changed: Changes,
    blocks: HashMap<(u32, u32), Kept>,
    /// Blocks that were integrated for the last scene.
    integrated: usize,
    /// Blocks that the last scene has in common with the one before.
    recalled: usize,
}

/// The number of the scene in which each element and surface last changed.
#[derive(Debug, Default)]
struct Changes {
    elements: Vec<u64>,
    surfaces: Vec<u64>,
}

/// What the blocks of an element follow from.
#[derive(Debug, PartialEq)]
struct Piece {
    patches: Vec<Patch>,
    basis: AreaBasis,
    contact: Option<usize>,
}

impl Piece {
    fn of(element: &Element) -> Self {
        Self { patches: element.patches.clone(), basis: element.basis.clone(), contact: element.contact }
    }
}

/// A block with what it was integrated for.
#[derive(Debug)]
struct Kept {
    request: Request,
    /// Number of the scene for which it was integrated.
    scene: u64,
    answer: Arc<Answer>,
}

/// What is asked of a block beside its elements.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::transport) struct Request {
    pub row: u32,
    pub column: u32,
    /// Surfaces that may hide a part of the pair, and the other faces of the bodies that they close.
    pub surfaces: Vec<usize>,
    /// All numbers that say how accurate it has to be, as bits.
    pub numbers: Vec<u64>,
}

/// A block, and its first entry as integrated with the elements exchanged, where that was done.
#[derive(Debug)]
pub(in crate::transport) struct Answer {
    pub block: Block,
    pub exchanged: OnceLock<Option<f64>>,
}

impl Answer {
    pub(in crate::transport) fn of(block: Block) -> Self {
        Self { block, exchanged: OnceLock::new() }
    }
}

impl Memory {
    /// Takes note of what differs in the next scene from the one before. Where the number of surfaces or elements
    /// is another, all is forgotten.
    pub(crate) fn turn_to(&mut self, scene: &Scene, elements: &Elements) {
        let surfaces: Vec<Arc<dyn Surface>> =
            scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect();
        let list: Vec<Piece> = elements.list().iter().map(Piece::of).collect();
        if surfaces.len() != self.surfaces.len() || list.len() != self.elements.len() {
            let changed = Changes { elements: vec![1; list.len()], surfaces: vec![1; surfaces.len()] };
            *self = Self { changed, ..Self::default() };
        }
        self.scenes += 1;
        let Changes { elements: moved, surfaces: shifted } = &mut self.changed;
        for ((old, new), changed) in self.surfaces.iter().zip(&surfaces).zip(shifted) {
            if !Arc::ptr_eq(old, new) {
                *changed = self.scenes;
            }
        }
        for ((old, new), changed) in self.elements.iter().zip(&list).zip(moved) {
            if old != new {
                *changed = self.scenes;
            }
        }
        (self.surfaces, self.elements) = (surfaces, list);
    }

    /// The block that answers a request, where nothing has changed since it was integrated.
    pub(in crate::transport) fn recall(&self, request: &Request) -> Option<&Arc<Answer>> {
        let kept = self.blocks.get(&(request.row, request.column))?;
        let Changes { elements, surfaces } = &self.changed;
        let ends = [request.row, request.column].map(|element| elements[element as usize]);
        let blockers = request.surfaces.iter().map(|surface| surfaces[*surface]);
        let is_valid = ends.into_iter().chain(blockers).all(|changed| changed <= kept.scene);
        (is_valid && kept.request == *request).then_some(&kept.answer)
    }

    /// Keeps the answers to the requests of this scene, and forgets all others.
    pub(in crate::transport) fn keep(&mut self, answers: Vec<(Request, Arc<Answer>)>) {
        let mut blocks = HashMap::with_capacity(answers.len());
        (self.integrated, self.recalled) = (0, 0);
        for (request, answer) in answers {
            let before = self.blocks.get(&(request.row, request.column));
            let is_old = before.is_some_and(|kept| Arc::ptr_eq(&kept.answer, &answer));
            self.recalled += usize::from(is_old);
            self.integrated += usize::from(!is_old);
            let scene = before.filter(|_| is_old).map_or(self.scenes, |kept| kept.scene);
            blocks.insert((request.row, request.column), Kept { request, scene, answer });
        }
        self.blocks = blocks;
    }

    /// Blocks that had to be integrated for the last scene.
    pub(crate) fn integrated(&self) -> usize {
        self.integrated
    }

    /// Blocks that were the same as before.
    pub(crate) fn recalled(&self) -> usize {
        self.recalled
    }
}
