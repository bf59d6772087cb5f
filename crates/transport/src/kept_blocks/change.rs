//! Differences between a scene and the one before: elements, surfaces and the starts of rays.

use std::sync::Arc;

use radiosity_elements::{Element, Elements};
use radiosity_geom::Surface;
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;

/// A scene, as far as blocks and rays follow from it.
#[derive(Debug)]
pub(super) struct SceneState {
    pub elements: Arc<Elements>,
    surfaces: Vec<Arc<dyn Surface>>,
    /// Fingerprint of the starts of rays on each surface.
    starts: Vec<[u64; 2]>,
}

/// Whether each element and surface is another than in the scene before, and whether rays start on each
/// surface in another way.
#[derive(Debug)]
pub(crate) struct SceneChange {
    pub elements: Vec<bool>,
    pub surfaces: Vec<bool>,
    pub starts: Vec<bool>,
}

impl SceneChange {
    /// Whether nothing has changed.
    pub(super) fn is_none(&self) -> bool {
        let Self { elements, surfaces, starts } = self;
        ![elements, surfaces, starts].into_iter().flatten().any(|is_other| *is_other)
    }

    /// Whether the rays of an element of a surface leave it otherwise than in the scene before.
    pub(crate) fn is_moved(&self, element: usize, surface: usize) -> bool {
        self.elements[element] || self.surfaces[surface] || self.starts[surface]
    }
}

impl SceneState {
    pub(super) fn of(scene: &Scene, elements: &Arc<Elements>, visibility: &Visibility) -> Self {
        Self {
            elements: Arc::clone(elements),
            surfaces: scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect(),
            starts: (0..scene.surfaces.len()).map(|surface| visibility.start_on(surface)).collect(),
        }
    }

    /// The difference from the scene before; None where that has other numbers of surfaces or elements.
    pub(super) fn change(&self, before: &Self) -> Option<SceneChange> {
        let is_alike = self.counts() == before.counts();
        is_alike.then(|| SceneChange {
            elements: differing(self.elements.list(), before.elements.list(), is_same),
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
        self.elements.list().iter().map(|element| element.surface)
    }

    /// Numbers of elements and of surfaces.
    pub(super) fn counts(&self) -> [usize; 2] {
        [self.elements.list().len(), self.surfaces.len()]
    }
}

/// Whether the same blocks follow from two elements.
fn is_same(a: &Element, b: &Element) -> bool {
    let is_one = a.surface == b.surface && a.is_of_part(b);
    is_one && a.patches == b.patches && a.basis == b.basis
}

/// Where two lists differ.
fn differing<T>(own: &[T], other: &[T], is_same: impl Fn(&T, &T) -> bool) -> Vec<bool> {
    own.iter().zip(other).map(|(a, b)| !is_same(a, b)).collect()
}
