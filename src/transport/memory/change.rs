//! What differs in a scene from the one before.

use std::sync::Arc;

use radiosity_geom::Surface;

use crate::elements::basis::AreaBasis;
use crate::elements::patch::Patch;
use crate::elements::{Element, Elements};
use crate::scene::Scene;
use crate::visibility::Visibility;

/// A scene, as far as blocks and rays follow from it.
#[derive(Debug, Default)]
pub(super) struct Seen {
    elements: Vec<Piece>,
    surfaces: Vec<Arc<dyn Surface>>,
    /// How rays start on each surface.
    starts: Vec<[u64; 2]>,
}

/// What the blocks of an element follow from.
#[derive(Debug, PartialEq)]
struct Piece {
    surface: usize,
    patches: Vec<Patch>,
    basis: AreaBasis,
    contact: Option<usize>,
}

/// Whether each element and surface is another than in the scene before, and whether rays start on each surface in another way.
#[derive(Debug)]
pub(super) struct Change {
    pub elements: Vec<bool>,
    pub surfaces: Vec<bool>,
    pub starts: Vec<bool>,
}

impl Piece {
    fn of(element: &Element) -> Self {
        let Element { surface, patches, basis, contact, .. } = element;
        Self { surface: *surface, patches: patches.clone(), basis: basis.clone(), contact: *contact }
    }
}

impl Seen {
    pub(super) fn of(scene: &Scene, elements: &Elements, visibility: &Visibility) -> Self {
        Self {
            elements: elements.list().iter().map(Piece::of).collect(),
            surfaces: scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect(),
            starts: (0..scene.surfaces.len()).map(|surface| visibility.start_on(surface)).collect(),
        }
    }

    /// What differs from the scene before; None where that has other numbers of surfaces or elements.
    pub(super) fn change(&self, before: &Self) -> Option<Change> {
        let are_as_many =
            self.surfaces.len() == before.surfaces.len() && self.elements.len() == before.elements.len();
        are_as_many.then(|| Change {
            elements: differing(&self.elements, &before.elements, |a, b| a == b),
            surfaces: differing(&self.surfaces, &before.surfaces, Arc::ptr_eq),
            starts: differing(&self.starts, &before.starts, |a, b| a == b),
        })
    }

    /// The surfaces that are marked.
    pub(super) fn marked(&self, marks: &[bool]) -> Vec<Arc<dyn Surface>> {
        let marked = self.surfaces.iter().zip(marks).filter(|(_, mark)| **mark);
        marked.map(|(surface, _)| Arc::clone(surface)).collect()
    }

    /// The surface of each element.
    pub(super) fn owners(&self) -> impl Iterator<Item = usize> {
        self.elements.iter().map(|piece| piece.surface)
    }

    /// Numbers of elements and of surfaces.
    pub(super) fn counts(&self) -> [usize; 2] {
        [self.elements.len(), self.surfaces.len()]
    }
}

/// Where two lists differ.
fn differing<T>(own: &[T], other: &[T], is_same: impl Fn(&T, &T) -> bool) -> Vec<bool> {
    own.iter().zip(other).map(|(a, b)| !is_same(a, b)).collect()
}
