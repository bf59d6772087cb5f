//! Where a ray from one element meets another.

use radiosity_elements::{Element, Elements};
use radiosity_geom::{DVec2, DVec3, Encounter};
use radiosity_kernel::blocks::held_rows::HeldRows;
use serde::{Deserialize, Serialize};

use crate::sampled::sender::Departure;

/// A ray from one element that first meets the front of another, or of its own.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Hit {
    /// Element that sent it.
    pub source: u32,
    /// Element that it meets.
    pub target: u32,
    /// Half of the rays to which the ray belongs: 0 or 1.
    pub half: u32,
    /// Weight of the ray ([`Departure::weight`]), negative where it is taken back.
    pub weight: f64,
    /// Coordinates in the frame of its source's basis.
    pub from: [f64; 2],
    /// Coordinates in the frame of its target's basis.
    pub to: [f64; 2],
}

impl Hit {
    /// Its two elements, the one that comes first in front.
    pub(super) fn pair(&self) -> (u32, u32) {
        (self.source.min(self.target), self.source.max(self.target))
    }

    /// Whether a rank counts it: one that holds one of its elements.
    pub(super) fn is_counted_by(&self, rank: usize, held: &HeldRows) -> bool {
        [self.source, self.target].iter().any(|end| held.rank(*end as usize) == rank)
    }

    /// This hit, taken back.
    pub(super) fn taken_back(self) -> Self {
        Self { weight: -self.weight, ..self }
    }

    /// 1; −1 where it is taken back.
    pub(super) fn count(&self) -> i32 {
        if self.weight < 0.0 { -1 } else { 1 }
    }
}

/// The hit of the ray of number `index` from element `source`, given what it meets first; none where it
/// leaves the scene or meets a back, which absorbs it.
pub(super) fn hit(
    elements: &Elements,
    source: usize,
    index: u64,
    departure: &Departure,
    met: Option<Encounter>,
) -> Option<Hit> {
    let Departure { node, direction, weight } = departure;
    let sender = &elements.list()[source];
    let Encounter { surface, hit, front, .. } = met?;
    if !front {
        return None;
    }
    let target = elements.at(surface, [hit.u, hit.v])?;
    let receiver = &elements.list()[target];
    if receiver.contact.is_some() {
        return None;
    }
    let position = node.position + *direction * hit.t;
    Some(Hit {
        source: source as u32,
        target: target as u32,
        half: (index % 2) as u32,
        weight: *weight,
        from: locate(sender, node.position, node.parameters),
        to: locate(receiver, position, DVec2::new(hit.u, hit.v)),
    })
}

fn locate(element: &Element, position: DVec3, parameters: DVec2) -> [f64; 2] {
    element.basis.frame().locate(position, parameters)
}
