//! Whether light can reach a part of a surface.
//!
//! Rays leave from places all over the part in directions all over the half-space. The part is sealed off if
//! each ray first meets the back of a surface. Where two bodies touch, only one side, or none, may separate
//! them: a ray may then also end on the front of a part that is itself sealed off. Parts that depend on each
//! other in this way have to be the smaller parts of their surfaces; otherwise a whole room would count as a
//! footprint.

use radiosity_geom::{Aabb, Bvh, DVec3, Encounter, PlanarRegion, Ray, touching};
use radiosity_scene::Scene;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use super::footprint::Footprint;
use crate::{Visibility, golden_spiral};

/// Rays from each place, evenly over the half-space. An arbitrary choice: an opening that takes less than a
/// 64th of it may be missed from a place, and what light reaches through it counts as dark; more rays take
/// time in proportion.
const RAYS: usize = 64;
/// Position of places between the middle of a piece and its corners, 0 to 1: near the corners, where gaps
/// are, and off the lines of contact by more than any tolerance.
const OUTWARD: f64 = 0.95;

/// A part of a surface that may be sealed off.
pub(super) struct SealCandidate {
    pub(super) footprint: Footprint,
    places: Vec<DVec3>,
    /// Whether it is less than half of its surface, so that other parts may depend on it.
    is_minor: bool,
}

impl SealCandidate {
    /// A suspect part of the surface with the region `region`.
    pub(super) fn new(footprint: Footprint, region: &PlanarRegion) -> Self {
        let pieces = footprint.region.convex_pieces();
        let inside = |piece: &Vec<DVec3>| {
            let middle = piece.iter().sum::<DVec3>() / piece.len() as f64;
            let corners = piece.iter().map(move |corner| middle.lerp(*corner, OUTWARD));
            std::iter::once(middle).chain(corners).collect::<Vec<_>>()
        };
        let places = pieces.iter().flat_map(inside).filter(|x| region.contains(*x)).collect();
        let is_minor = footprint.region.area() < 0.5 * region.area();
        Self { footprint, places, is_minor }
    }
}

/// Suspects that are found by place.
struct Parts<'a> {
    list: &'a [SealCandidate],
    tree: Bvh,
}

impl Parts<'_> {
    /// The first of the minor parts of a surface that contain a point.
    fn minor_at(&self, surface: usize, point: DVec3) -> Option<usize> {
        let holds = |index: &usize| {
            let SealCandidate { footprint, is_minor, .. } = &self.list[*index];
            *is_minor && footprint.surface == surface && footprint.region.contains(point)
        };
        self.tree.search(|bounds| bounds.contains(point)).filter(holds).min()
    }
}

/// Drops the places of each part that lie in a smaller part.
pub(super) fn keep_apart(suspects: &mut [SealCandidate]) {
    let regions: Vec<PlanarRegion> =
        suspects.iter().map(|suspect| suspect.footprint.region.clone()).collect();
    let tree = tree(suspects.iter());
    for (own, suspect) in suspects.iter_mut().enumerate() {
        let covers = |other: usize, x: DVec3| {
            regions[other].area() < regions[own].area() && regions[other].contains(x)
        };
        suspect.places.retain(|x| !tree.search(|bounds| bounds.contains(*x)).any(|other| covers(other, *x)));
    }
}

/// The boxes of the parts, inflated by more than the 1e-6 of the extent at which a point off the plane still
/// counts.
fn tree<'a>(suspects: impl Iterator<Item = &'a SealCandidate>) -> Bvh {
    let around = |suspect: &SealCandidate| {
        let region = &suspect.footprint.region;
        Aabb::around(region.outer().iter().copied()).inflate(2e-6 * region.extent())
    };
    Bvh::build(&suspects.map(around).collect::<Vec<_>>())
}

/// Which of the suspects are sealed off.
pub(super) fn sealed(scene: &Scene, obstacles: &Visibility, suspects: &[SealCandidate]) -> Vec<bool> {
    let parts = Parts { list: suspects, tree: tree(suspects.iter()) };
    let seen: Vec<Option<Vec<usize>>> =
        suspects.par_iter().map(|suspect| fronts_seen(scene, obstacles, &parts, suspect)).collect();
    let mut sealed: Vec<bool> = seen.iter().map(Option::is_some).collect();
    loop {
        let holds = |own: usize| {
            let fronts = seen[own].as_deref().unwrap_or_default();
            sealed[own] && fronts.iter().all(|other| sealed[*other])
        };
        let next: Vec<bool> = (0..suspects.len()).map(holds).collect();
        if next == sealed {
            return sealed;
        }
        sealed = next;
    }
}

/// The suspects whose fronts are seen from the part `own`, ascending; None where a ray meets another front or
/// leaves the scene.
fn fronts_seen(
    scene: &Scene,
    obstacles: &Visibility,
    parts: &Parts<'_>,
    own: &SealCandidate,
) -> Option<Vec<usize>> {
    if own.places.is_empty() {
        return None;
    }
    let normal = own.footprint.region.normal();
    let clear = touching(own.footprint.region.extent(), 0.0);
    let first = (own.footprint.region.outer()[1] - own.footprint.region.outer()[0]).normalize();
    let axes = [first, normal.cross(first), normal];
    let mut seen = Vec::new();
    for origin in &own.places {
        check_interrupt();
        for direction in directions(axes) {
            let ray = Ray { origin: *origin, direction, range: [clear, f64::INFINITY] };
            let Encounter { surface, hit, front, .. } = obstacles.nearest(&ray)?;
            if !front {
                continue;
            }
            let there = scene.surfaces[surface].shape.jet(hit.u, hit.v);
            seen.push(parts.minor_at(surface, there.position).filter(|_| own.is_minor)?);
        }
    }
    seen.sort_unstable();
    seen.dedup();
    Some(seen)
}

/// Directions evenly over the half-space of the last axis, along a golden spiral.
fn directions([first, second, up]: [DVec3; 3]) -> impl Iterator<Item = DVec3> {
    (0..RAYS).map(move |k| {
        let cosine = (k as f64 + 0.5) / RAYS as f64;
        let (sin, cos) = golden_spiral::turn(k);
        (1.0 - cosine * cosine).sqrt() * (cos * first + sin * second) + cosine * up
    })
}
