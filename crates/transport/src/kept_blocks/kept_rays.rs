//! Hits of rays in the scene before, taken again where nothing has come into their way.
//!
//! A ray meets the nearest of all surfaces. Where neither its element nor what it met has changed, it meets
//! that again, to the bit, unless a surface that has changed comes before it: only those are asked
//! (`ChangedSurfaces`).

use std::sync::Arc;

use radiosity_geom::{Aabb, DVec3, Encounter, Hit, RayTree};
use serde::{Deserialize, Serialize};

/// Most rays that are kept, by all ranks and all sequences of rays together; others are traced in every
/// scene. Chosen: half a gigabyte, the rays of the scene before and those of this one.
pub const MOST: u64 = 1 << 23;

/// Bytes of a ray that is kept.
pub const BYTES: u64 = size_of::<KeptHit>() as u64;

/// The surface of a ray that met nothing.
const NOTHING: u32 = u32::MAX;

/// The hit of a ray: twice the number of the surface, plus 1 at its back, then distance and parameters (t, u,
/// v).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct KeptHit {
    surface: u32,
    hit: [f64; 3],
}

/// Rays of one element, by their index, with their hits.
#[derive(Debug, Default)]
pub(super) struct ElementRays {
    /// Number that the rays follow from beside their element.
    number: u64,
    hits: Vec<KeptHit>,
}

/// Surfaces that have changed and may come into the way of rays.
#[derive(Debug)]
pub(crate) struct ChangedSurfaces {
    /// Whether each surface has changed.
    pub surfaces: Vec<bool>,
    /// Boxes of the surfaces that have changed, where they are now.
    pub boxes: Vec<Aabb>,
    /// Tree of these surfaces.
    pub tree: RayTree,
    /// [`RayTree::reach`] of all surfaces.
    pub reach: f64,
}

/// Hits of the rays of one sequence, in the scene before and in this one.
#[derive(Debug)]
pub(crate) struct KeptRays {
    before: Vec<ElementRays>,
    now: Vec<ElementRays>,
    changed: Arc<ChangedSurfaces>,
    /// Number of rays that still may be kept.
    room: u64,
    counts: RayCounts,
}

/// Numbers of rays for a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// Rays that were traced.
    pub traced: u64,
    /// Rays that met what they had met in the scene before, and were not traced.
    pub recalled: u64,
}

impl ChangedSurfaces {
    /// Whether one of these surfaces may come before `end` (in multiples of the direction) in the way of a
    /// ray, from its origin in its direction.
    pub(crate) fn may_hide(&self, [origin, direction]: [DVec3; 2], end: f64) -> bool {
        self.tree.may_come_before(origin, direction, end, self.reach)
    }
}

impl KeptHit {
    pub(crate) fn of(encounter: Option<&Encounter>) -> Self {
        match encounter {
            None => Self { surface: NOTHING, hit: [f64::INFINITY; 3] },
            Some(Encounter { surface, hit, front, .. }) => {
                Self { surface: 2 * *surface as u32 + u32::from(!front), hit: [hit.t, hit.u, hit.v] }
            }
        }
    }

    /// The surface that is met; None of a ray that meets nothing.
    pub(crate) fn surface(&self) -> Option<usize> {
        (self.surface != NOTHING).then_some((self.surface / 2) as usize)
    }

    /// Distance to where it is met (scene length); infinite where nothing is.
    pub(crate) fn distance(&self) -> f64 {
        self.hit[0]
    }

    pub(crate) fn encounter(self) -> Option<Encounter> {
        let [t, u, v] = self.hit;
        let surface = (self.surface / 2) as usize;
        let (hit, front) = (Hit { t, u, v }, self.surface.is_multiple_of(2));
        (self.surface != NOTHING).then_some(Encounter { surface, hit, front, normal: None })
    }
}

impl ElementRays {
    /// The hits of these rays if they have this number, else none.
    fn of_number(self, number: u64) -> Self {
        let hits = if self.number == number { self.hits } else { Vec::new() };
        Self { number, hits }
    }
}

impl KeptRays {
    /// Rays `before` of elements that are as they were and whose rays have these `numbers`, with room for so
    /// many rays of this scene.
    pub(super) fn new(
        before: Vec<ElementRays>,
        numbers: &[u64],
        changed: Arc<ChangedSurfaces>,
        room: u64,
    ) -> Self {
        let before = before.into_iter().zip(numbers).map(|(rays, number)| rays.of_number(*number)).collect();
        let now = numbers.iter().map(|number| ElementRays { number: *number, hits: Vec::new() }).collect();
        Self { before, now, changed, room, counts: RayCounts::default() }
    }

    /// Hit of ray number `index` of an element, from its origin in its direction, as in the scene before
    /// (None inside: it meets nothing); None where it has to be traced.
    pub(crate) fn get(
        &self,
        element: usize,
        index: u64,
        [origin, direction]: [DVec3; 2],
    ) -> Option<Option<Encounter>> {
        let encounter = self.before.get(element)?.hits.get(index as usize)?.encounter();
        if encounter.is_some_and(|encounter| self.changed.surfaces[encounter.surface]) {
            return None;
        }
        let end = encounter.map_or(f64::INFINITY, |encounter| encounter.hit.t);
        (!self.changed.may_hide([origin, direction], end)).then_some(encounter)
    }

    /// Keeps what rays of an element met, the first of them of this index, and counts how many had been
    /// `recalled`.
    pub(crate) fn insert(&mut self, element: usize, first: u64, hits: &[KeptHit], recalled: u64) {
        self.counts.recalled += recalled;
        self.counts.traced += hits.len() as u64 - recalled;
        let kept = &mut self.now[element].hits;
        if kept.len() as u64 == first {
            let count = self.room.min(hits.len() as u64);
            kept.extend_from_slice(&hits[..count as usize]);
            self.room -= count;
        }
    }

    /// Hits of the rays of an element in this scene, as far as there was room.
    pub(crate) fn hits(&self, element: usize) -> &[KeptHit] {
        &self.now[element].hits
    }

    /// How many rays were traced, and how many were not.
    pub(crate) fn counts(&self) -> RayCounts {
        self.counts
    }

    /// The rays of this scene, kept for the next one, and how many were traced.
    pub(super) fn into_rays(self) -> (Vec<ElementRays>, RayCounts) {
        (self.now, self.counts)
    }
}
