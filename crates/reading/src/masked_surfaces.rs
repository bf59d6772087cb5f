//! Shadow masks of a solution, by pairs of surfaces.

use std::collections::BTreeMap;
use std::fmt;

use radiosity_published::zatz1993::masked_light::MaskOfPair;
use radiosity_scene::Scene;
use radiosity_solve::solution::Solution;
use serde::Serialize;

use radiosity_work::digits::decimals;

/// The shadow masks between the elements of two surfaces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MaskedSurfaces {
    /// Name of the surface whose light is masked.
    pub emitter: String,
    /// Name of the surface on which it is.
    pub receiver: String,
    /// Cells along each side of the mask of an element, were all as fine as the finest may be.
    pub cells: usize,
    /// Nodes that were sampled, of all masks.
    pub samples: usize,
    /// Number of masks: pairs of their elements.
    pub masks: usize,
    /// Mean of the masks: 1 where all light arrives. Masks count by the areas of both elements.
    pub mean: f64,
    /// Whether the scene chose the pair; else it was found.
    pub chosen: bool,
}

/// Sums over the masks between two surfaces.
#[derive(Default)]
struct Sums {
    masks: usize,
    samples: usize,
    weight: f64,
    weighted: f64,
}

impl MaskedSurfaces {
    /// The masks of a solution, in the order of receivers, then of emitters; none where nothing is masked.
    pub(crate) fn of(scene: &Scene, solution: &Solution) -> Vec<Self> {
        let list = solution.elements().list();
        let mut sums: BTreeMap<(usize, usize, usize, bool), Sums> = BTreeMap::new();
        for MaskOfPair { receiver, emitter, cells, samples, mean, is_chosen } in
            solution.masked().into_iter().flat_map(|masked| masked.masks())
        {
            let (receiver, emitter) = (&list[receiver], &list[emitter]);
            let own = sums.entry((receiver.surface, emitter.surface, cells, is_chosen)).or_default();
            let weight = receiver.area * emitter.area;
            own.masks += 1;
            own.samples += samples;
            own.weight += weight;
            own.weighted += weight * mean;
        }
        let name = |surface: usize| scene.surfaces[surface].name.clone();
        let of_surfaces = |((receiver, emitter, cells, chosen), sums): ((_, _, _, _), Sums)| Self {
            emitter: name(emitter),
            receiver: name(receiver),
            cells,
            samples: sums.samples,
            masks: sums.masks,
            mean: sums.weighted / sums.weight,
            chosen,
        };
        sums.into_iter().map(of_surfaces).collect()
    }
}

impl fmt::Display for MaskedSurfaces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { emitter, receiver, cells, samples, masks, mean, chosen } = self;
        let masks = if *masks == 1 { "1 mask".to_owned() } else { format!("{masks} masks") };
        let why = if *chosen { "chosen" } else { "automatic" };
        let mean = decimals(*mean, 3);
        write!(
            f,
            "'{emitter}' on '{receiver}': {masks} of {cells} × {cells} cells at the finest, {samples} samples, mean {mean}, {why}"
        )
    }
}
