//! The spots of one frame: their places, and their light, gathered there.

use std::collections::{BTreeSet, HashMap};

use radiosity_elements::Elements;
use radiosity_light::penumbra::RayEffort;
use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};
use serde::{Deserialize, Serialize};

use super::lattice::Lattice;
use super::spot::Spot;
use crate::pictures::eye::SeenPlace;
use crate::pictures::picture_light::{ComputedLight, PictureLight};
use crate::pictures::pixel_count::PixelCount;

/// Rays for direct light at a node, which tells how accurate other light is to be. Chosen.
const AT_NODES: RayEffort = RayEffort { error_factor: 3.0, sure: false };

/// The light of a spot.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct SpotLight {
    /// Its place.
    pub seen: SeenPlace,
    /// Reflected light there.
    pub light: ComputedLight,
    /// About the direct light there, the sum over the bands (W m⁻²).
    pub lit: f64,
}

/// Reflected light at the spots of one frame, with none kept.
pub(crate) struct SpotGatherer<'a> {
    light: &'a PictureLight<'a>,
    elements: &'a Elements,
    /// Diagonal of the scene's bounding box (scene length).
    diagonal: f64,
    lattices: HashMap<usize, Lattice>,
}

impl<'a> SpotGatherer<'a> {
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

    /// The light of these spots; None where they have no place.
    pub(crate) fn spots(&self, wanted: &[Spot], work: &Work<'_>) -> Vec<Option<SpotLight>> {
        let count = PixelCount::new(wanted.len(), Stage::GatheredPixels, work);
        let spot = |index: usize| {
            let own = wanted[index];
            let error_factor = if let Spot::Place(place) = own { place.error_factor() } else { 1.0 };
            let light = self.place(own).map(|seen| self.gathered(&seen, error_factor));
            count.add();
            light
        };
        work.ranks.map_even(PartName::GatheredLight, wanted.len(), 1, spot)
    }

    /// The place of a spot; None of a node where no open place is near or in a narrow gap, and where something lies on
    /// a place.
    pub(crate) fn place(&self, spot: Spot) -> Option<SeenPlace> {
        match spot {
            Spot::Place(place) => {
                SeenPlace::at(self.elements, spot.surface(), place.parameters(), self.diagonal)
            }
            Spot::Node(node) => {
                let seen = self.lattice(node.surface).place(self.elements, node, self.diagonal)?;
                (!self.light.is_in_gap(&seen)).then_some(seen)
            }
        }
    }

    /// The light of a place with `error_factor` times the usual error.
    pub(crate) fn gathered(&self, seen: &SeenPlace, error_factor: f64) -> SpotLight {
        let lit = self.light.direct(seen, None, AT_NODES).bands;
        SpotLight { seen: *seen, light: self.light.rest(seen, &lit, error_factor), lit: lit.iter().sum() }
    }
}
