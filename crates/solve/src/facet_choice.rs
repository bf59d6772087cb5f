//! Whether each pair of the elements of a scene has rays of its own: where there are many small flat ones.

use radiosity_elements::Elements;
use radiosity_scene::Scene;
use radiosity_transport::FacetTransport;
use radiosity_visibility::Visibility;
use radiosity_work::Work;

/// Fewest elements whose pairs have rays of their own. Chosen: a few large ones are told apart better by rays of each.
const FEWEST: usize = 256;

/// Bytes of the pairs of elements.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairBytes {
    /// Of a pair, at the most.
    pub each: f64,
    /// Of all pairs, where nothing else is said.
    pub usually_most: f64,
    /// Of all pairs, where that is said.
    pub allowed: Option<u64>,
}

impl PairBytes {
    /// Whether they suffice for so many elements.
    pub(crate) fn suffice(&self, elements: usize) -> bool {
        self.needed(elements) <= self.allowed.map_or(self.usually_most, |bytes| bytes as f64)
    }

    /// Bytes of all pairs of so many elements.
    pub(crate) fn needed(&self, elements: usize) -> f64 {
        self.each * 0.5 * (elements as f64).powi(2)
    }
}

/// Whether a scene has many flat surfaces and no others: they are left uncut.
pub(crate) fn are_many_flat(scene: &Scene) -> bool {
    scene.surfaces.len() >= FEWEST && scene.surfaces.iter().all(|surface| surface.shape.region().is_some())
}

/// The transport by rays of each pair to this accuracy, where the elements are many, flat and of constants, and memory
/// suffices.
pub(crate) fn of_many_flat<'a>(
    elements: &'a Elements,
    visibility: &'a Visibility,
    eps: f64,
    bytes: PairBytes,
    work: &'a Work<'a>,
) -> Option<FacetTransport<'a>> {
    let list = elements.list();
    let are_constants = list.iter().all(|element| element.basis.len() == 1);
    if list.len() < FEWEST || !are_constants || !bytes.suffice(list.len()) {
        return None;
    }
    FacetTransport::new(elements, visibility, eps, work)
}
