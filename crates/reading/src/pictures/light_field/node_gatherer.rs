//! The nodes of one frame: their places, and their light, gathered there.

use std::collections::{BTreeSet, HashMap};

use radiosity_elements::Elements;
use radiosity_light::penumbra::RayEffort;
use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};
use serde::{Deserialize, Serialize};

use super::lattice::Lattice;
pub(crate) use super::lattice::NodeIndex;
use crate::pictures::eye::SeenPlace;
use crate::pictures::picture_light::{ComputedLight, PictureLight};
use crate::pictures::pixel_count::PixelCount;

/// Rays for direct light at a node, which tells how accurate other light is to be. Chosen.
const AT_NODES: RayEffort = RayEffort { error_factor: 3.0, sure: false };

/// A node of a lattice.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Node {
    /// Its place.
    pub seen: SeenPlace,
    /// Reflected light there.
    pub light: ComputedLight,
    /// About the direct light there, the sum over the bands (W m⁻²).
    pub lit: f64,
}

/// Reflected light at the nodes of one frame, with none kept.
pub(crate) struct NodeGatherer<'a> {
    light: &'a PictureLight<'a>,
    elements: &'a Elements,
    /// Diagonal of the scene's bounding box (scene length).
    diagonal: f64,
    lattices: HashMap<usize, Lattice>,
}

impl<'a> NodeGatherer<'a> {
    /// The gatherer of `light` in a scene of this diagonal.
    pub(crate) fn new(light: &'a PictureLight<'a>, diagonal: f64) -> Self {
        let elements = light.solution().elements();
        Self { light, elements, diagonal, lattices: HashMap::new() }
    }

    /// The light.
    pub(crate) fn light(&self) -> &'a PictureLight<'a> {
        self.light
    }

    /// Makes the lattices of these surfaces.
    pub(crate) fn prepare(&mut self, surfaces: impl Iterator<Item = usize>) {
        let surfaces: BTreeSet<usize> = surfaces.collect();
        for surface in surfaces {
            let make = || Lattice::of(self.elements, surface, self.diagonal);
            self.lattices.entry(surface).or_insert_with(make);
        }
    }

    /// The lattices of a surface, which are made.
    pub(super) fn lattice(&self, surface: usize) -> &Lattice {
        &self.lattices[&surface]
    }

    /// The light of these nodes; None where no open place is near, and in narrow gaps.
    pub(crate) fn nodes(&self, wanted: &[NodeIndex], work: &Work<'_>) -> Vec<Option<Node>> {
        let count = PixelCount::new(wanted.len(), Stage::GatheredPixels, work);
        let node = |place: usize| {
            let node = self.node(wanted[place]);
            count.add();
            node
        };
        work.ranks.map_even(PartName::GatheredLight, wanted.len(), 1, node)
    }

    /// The place of a node; None where no open place is near, and in narrow gaps.
    pub(crate) fn place(&self, node: NodeIndex) -> Option<SeenPlace> {
        let seen = self.lattice(node.surface).place(self.elements, node, self.diagonal)?;
        (!self.light.is_in_gap(&seen)).then_some(seen)
    }

    /// The light of a node; None where it has no place.
    pub(crate) fn node(&self, node: NodeIndex) -> Option<Node> {
        let seen = self.place(node)?;
        let lit = self.light.direct(&seen, None, AT_NODES).bands;
        Some(Node { seen, light: self.light.rest(&seen, &lit, 1.0), lit: lit.iter().sum() })
    }

    /// The light of a place with `error_factor` times the usual error.
    pub(crate) fn gathered(&self, seen: &SeenPlace, error_factor: f64) -> ComputedLight {
        self.light.rest(seen, &self.light.direct(seen, None, AT_NODES).bands, error_factor)
    }
}
