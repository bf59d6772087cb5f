//! The backs that heat reaches.
//!
//! Heat that arrives at the back of a surface of one side stays in the scene, or is given by it: by default a back is
//! adiabatic ([`BackCondition`]). So backs are surfaces of the balance where heat reaches them. Whether it does, n
//! rays of Lambert's law tell that leave either side of every surface: a back that all of them miss takes less than
//! about 3/n of the sight of any side.

use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::sampling::area_preserving_map::AreaPreservingMap;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::lambert::lambert;
use radiosity_geom::{DVec3, PlanarRegion, RayTree, Rect, Surface};
use radiosity_scene::{BackCondition, Scene};
use radiosity_visibility::footprints::{Footprint, footprints};
use rayon::prelude::*;

/// Rays that leave each side in a scene of few surfaces. Chosen: what they miss takes less than .3 % of the sight.
const RAYS: u64 = 1024;

/// Most rays in all, but for [`LEAST_RAYS`] from each side. Chosen: about a second of one core.
const ALL_RAYS: u64 = 1 << 20;
const LEAST_RAYS: u64 = 64;

/// Rays that have to join two sides: one alone may have slipped through a seam.
const LEAST_MET: u64 = 2;

/// Distance over the size of a surface within which another lies on it, and heat is conducted. Chosen: as near as
/// faces touch.
const TOUCHES: f64 = 1e-6;

/// The scene with the backs that have a temperature or are reached by heat, behind all its surfaces.
pub(super) fn with_backs(scene: &Scene) -> Scene {
    scene.with_backs(&reached_backs(scene))
}

/// The surfaces of one side whose backs have a temperature or are reached by heat.
pub(super) fn reached_backs(scene: &Scene) -> Vec<usize> {
    let one_sided = scene.one_sided();
    let is_reached = reached(scene, &one_sided);
    let is_wanted = |surface: &usize| match scene.surfaces[*surface].back_condition() {
        BackCondition::Adiabatic => is_reached[*surface],
        BackCondition::Front | BackCondition::Temperature(_) => true,
    };
    one_sided.into_iter().filter(is_wanted).collect()
}

/// A side that sends and receives heat.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Side {
    /// The front of any surface.
    Front,
    /// The back of this surface, which is of one side.
    Back(usize),
}

/// Whether heat reaches the back of each surface of one side, from fronts or from backs that it reaches.
fn reached(scene: &Scene, one_sided: &[usize]) -> Vec<bool> {
    let joined = Sight::of(scene, one_sided).joined();
    let mut is_reached = vec![false; scene.surfaces.len()];
    loop {
        let mut is_done = true;
        for pair in &joined {
            let has_heat = pair.map(|side| match side {
                Side::Front => true,
                Side::Back(surface) => is_reached[surface],
            });
            for side in pair.iter().filter(|_| has_heat[0] != has_heat[1]) {
                if let Side::Back(surface) = side {
                    is_reached[*surface] = true;
                    is_done = false;
                }
            }
        }
        if is_done {
            return is_reached;
        }
    }
}

/// The surfaces of a scene, for rays between their sides.
struct Sight {
    /// Parts of each surface on which bodies stand, which exchange nothing.
    covered: Vec<Vec<PlanarRegion>>,
    shapes: Vec<Arc<dyn Surface>>,
    /// Whether each is of one side.
    has_back: Vec<bool>,
    tree: RayTree,
    /// Number of rays from each side.
    rays: u64,
}

impl Sight {
    fn of(scene: &Scene, one_sided: &[usize]) -> Self {
        let shapes: Vec<Arc<dyn Surface>> =
            scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect();
        let sides = 2 * shapes.len().max(1) as u64;
        let mut has_back = vec![false; shapes.len()];
        one_sided.iter().for_each(|surface| has_back[*surface] = true);
        // The back of what lies on another surface has no view.
        let lying: HashSet<&str> = scene.fitted.lying.iter().map(|own| own.surface.as_str()).collect();
        let names = scene.surfaces.iter().map(|surface| surface.name.as_str());
        has_back.iter_mut().zip(names).for_each(|(has_back, name)| *has_back &= !lying.contains(name));
        let mut covered = vec![Vec::new(); shapes.len()];
        for Footprint { surface, region, .. } in footprints(scene) {
            covered[surface].push(region);
        }
        Self {
            covered,
            has_back,
            tree: RayTree::new(shapes.clone()),
            rays: (ALL_RAYS / sides).clamp(LEAST_RAYS, RAYS),
            shapes,
        }
    }

    /// Pairs of sides that rays join, one of them at least a back, each once.
    fn joined(&self) -> Vec<[Side; 2]> {
        let met = (0..self.shapes.len()).into_par_iter().flat_map_iter(|surface| {
            let back = self.has_back[surface].then_some(Side::Back(surface));
            [Some(Side::Front), back].into_iter().flatten().flat_map(move |side| self.met(surface, side))
        });
        let mut rays: BTreeMap<[Side; 2], u64> = BTreeMap::new();
        for pair in met.collect::<Vec<_>>() {
            *rays.entry(pair).or_default() += 1;
        }
        rays.into_iter().filter(|(_, rays)| *rays >= LEAST_MET).map(|(pair, _)| pair).collect()
    }

    /// Whether a body stands on a place of a surface.
    fn is_covered(&self, surface: usize, place: DVec3) -> bool {
        self.covered[surface].iter().any(|region| region.contains(place))
    }

    /// This side of a surface and what each of its rays met, where one of them is a back.
    fn met(&self, surface: usize, side: Side) -> Vec<[Side; 2]> {
        let shape = &self.shapes[surface];
        let points = AreaPreservingMap::of(&patches(shape));
        let least = TOUCHES * shape.bounds(&Rect::FULL).diagonal();
        let met = |ray: u64| {
            let [s, t, polar, turn] = kronecker::point(ray);
            let Node { position, normal, .. } = points.point([s, t]).node;
            let normal = if side == Side::Front { normal } else { -normal };
            let along = lambert(normal, [polar, turn]);
            let met = self.tree.nearest_from(surface, position, along)?;
            let end = position + met.hit.t * along;
            if self.is_covered(surface, position) || self.is_covered(met.surface, end) {
                return None;
            }
            let other = match met.front {
                true => Side::Front,
                false if self.has_back[met.surface] => Side::Back(met.surface),
                false => return None,
            };
            (met.hit.t > least && [side, other] != [Side::Front; 2])
                .then(|| [side.min(other), side.max(other)])
        };
        (0..self.rays).filter_map(met).collect()
    }
}

/// Patches that cover a surface.
fn patches(shape: &Arc<dyn Surface>) -> Vec<Patch> {
    match shape.region() {
        None => vec![Patch::curved(Arc::clone(shape), &Rect::FULL)],
        Some(region) => {
            let pieces = region.convex_pieces().iter();
            pieces.flat_map(|piece| Patch::of_polygon(piece, region.normal())).collect()
        }
    }
}
