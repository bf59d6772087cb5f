//! Pairs whose blocks are known but for what hides a part of them: parts of the inside of one sphere.
//!
//! There κ = 1/(4 π R²) between any two points, so that with the coefficients c of the constant 1
//!
//! ```text
//! G_ij = c_i c_jᵀ / (4 π R²) − H_ij ,
//! ```
//!
//! H_ij the part over the points that do not see each other. The rays that would land on j, or on i, if nothing
//! stood in their way are counted for H_ij alone: the error is that of the hidden part.

use std::collections::{BTreeMap, HashSet};
use std::f64::consts::PI;

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_geom::{ConvexSolid, DVec3, Encounter, Ray};

use crate::sampled::sender::Departure;

/// Pairs of elements of one surface each, on the inside of a sphere.
#[derive(Clone, Debug, Default)]
pub(super) struct UnhiddenPairs {
    /// The first entry of each block if nothing hid a part of it: the others are zero.
    first_entries: BTreeMap<(u32, u32), f64>,
}

impl UnhiddenPairs {
    /// Those among `pairs`.
    pub(super) fn among(pairs: &HashSet<(u32, u32)>, list: &[Element]) -> Self {
        let first_entry = |&(row, column): &(u32, u32)| {
            let [a, b] = [row, column].map(|index| &list[index as usize]);
            let (_, radius) = sphere_around(a).filter(|_| a.surface == b.surface)?;
            Some(((row, column), a.constant[0] * b.constant[0] / (4.0 * PI * radius * radius)))
        };
        Self { first_entries: pairs.iter().filter_map(first_entry).collect() }
    }

    /// The first entry of the block of a pair if nothing hid a part of it, where that is known.
    pub(super) fn first_entry(&self, pair: (u32, u32)) -> Option<f64> {
        self.first_entries.get(&pair).copied()
    }

    /// The pairs in ascending order.
    pub(super) fn pairs(&self) -> impl Iterator<Item = (u32, u32)> {
        self.first_entries.keys().copied()
    }

    /// Where a ray of `element` would meet the element's own surface, if that is hidden by what it meets first.
    pub(super) fn hidden(
        &self,
        element: &Element,
        departure: &Departure,
        met: Option<&Encounter>,
    ) -> Option<Encounter> {
        if self.first_entries.is_empty() || met?.surface == element.surface {
            return None;
        }
        let (center, _) = sphere_around(element)?;
        let Departure { node, direction, .. } = departure;
        // Half the chord: from there on the ray leaves the sphere, and does not start on it.
        let middle = (center - node.position).dot(*direction) / direction.length_squared();
        let ray = Ray { origin: node.position, direction: *direction, range: [middle, f64::INFINITY] };
        let Some(Patch::Curved { surface, .. }) = element.patches.first() else { return None };
        let hit = surface.intersect(&ray)?;
        Some(Encounter { surface: element.surface, hit, front: true, normal: None })
    }
}

/// Centre and radius of the sphere whose inside is the front of an element, where there is one.
fn sphere_around(element: &Element) -> Option<(DVec3, f64)> {
    let Some(patch @ Patch::Curved { surface, .. }) = element.patches.first() else { return None };
    let Some(ConvexSolid::Ball { center, radius }) = surface.solid() else { return None };
    let node = patch.node(0.5, 0.5);
    (node.normal.dot(center - node.position) > 0.0).then_some((center, radius))
}
