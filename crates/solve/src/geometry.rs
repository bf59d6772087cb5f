//! The geometry of a scene as it prints for programmers: all that tells transfers between its surfaces from others.

use std::fmt;

use radiosity_elements::{Element, Elements};
use radiosity_scene::Scene;
use radiosity_work::ranks::journal::fingerprint;

/// The shapes of the surfaces of a scene, one after the other.
struct Shapes<'a>(&'a Scene);

impl fmt::Debug for Shapes<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.0.surfaces.iter().map(|surface| &surface.shape)).finish()
    }
}

/// A number that tells the geometry of a scene from others: of the shapes of its surfaces, in their order.
pub fn geometry(scene: &Scene) -> u64 {
    fingerprint(&Shapes(scene))
}

/// The geometry of an assembly: the surfaces of a scene, which may hide something, and the elements that they were cut
/// into, with pairs of these that are left out.
pub(crate) struct AssemblyGeometry<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) elements: &'a Elements,
    /// Whether two elements have a block.
    pub(crate) wanted: &'a dyn Fn(usize, usize) -> bool,
}

impl fmt::Debug for AssemblyGeometry<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list = self.elements.list();
        let element = |own: &Element| (own.surface, own.contact, own.basis.len(), own.hull.clone());
        let pairs = (0..list.len()).flat_map(|row| (row..list.len()).map(move |column| (row, column)));
        let unwanted = pairs.filter(|(row, column)| !(self.wanted)(*row, *column));
        Shapes(self.scene).fmt(f)?;
        f.debug_list().entries(list.iter().map(element)).finish()?;
        f.debug_list().entries(unwanted).finish()
    }
}
