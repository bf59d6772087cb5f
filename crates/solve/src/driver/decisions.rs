//! Decisions about a model before its elements are made: what carries its pairs, and how surfaces are cut.

use std::borrow::Cow;

use radiosity_elements::mesh::Mesh;
use radiosity_elements::{Discretization, Subdivide, usual_mesh};
use radiosity_published::bases::basis::Ground;
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;
use radiosity_work::Allowance;
use radiosity_work::ranks::Ranks;

use super::failure::Failure;
use super::forecast::rays_in_time;
use super::memory_need::{MemoryNeed, peak_of_mesh, require_memory_of_mesh};
use super::options::Options;
use super::transport_choice::TransportChoice;
use crate::facet_choice::are_many_flat;

/// The carrier of the pairs of a scene, and the cuts of its surfaces. Scenes that differ only in the places
/// of some things share a layout: what carries the light of things that turn does not depend on how they
/// stand to the axes.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    choice: TransportChoice,
    how: Discretization,
    mesh: Mesh,
}

/// Decisions that are not left to the scene.
#[derive(Default)]
pub(super) struct AssemblyPlan<'a> {
    /// The carrier of the pairs, if it is not left to the scene.
    pub choice: Option<TransportChoice>,
    /// Cuts of surfaces, if not those that the scene needs.
    pub how: Option<Discretization>,
    /// Cells of the surfaces, if not those that follow from `how`.
    pub mesh: Option<&'a Mesh>,
    /// The obstacles of the scene, where they are known.
    pub visibility: Option<Visibility>,
}

/// All decisions about a scene.
pub(super) struct Decisions<'a> {
    pub visibility: Visibility,
    /// The carrier of the pairs.
    pub choice: TransportChoice,
    /// Rays that carry the pairs, if any.
    pub rays: Option<u64>,
    /// Cuts of surfaces.
    pub how: Discretization,
    /// Cells of the surfaces, where they are known.
    pub mesh: Option<Cow<'a, Mesh>>,
    /// Whether there are other cells than follow from `how`.
    is_refined: bool,
}

impl Layout {
    /// Whether rays carry the pairs.
    pub(crate) fn is_by_rays(&self) -> bool {
        self.choice.sampled
    }

    /// The layout of `scene` by these options.
    pub(crate) fn of(scene: &Scene, options: &Options) -> Self {
        let Decisions { choice, how, mesh, .. } = AssemblyPlan::default().decided(scene, options, None);
        Self { choice, how, mesh: mesh.map_or_else(|| usual_mesh(scene, &how), Cow::into_owned) }
    }

    /// The plan of a model of this layout.
    pub(super) fn plan(&self) -> AssemblyPlan<'_> {
        let Self { choice, how, mesh } = self;
        AssemblyPlan {
            choice: Some(choice.clone()),
            how: Some(*how),
            mesh: Some(mesh),
            ..AssemblyPlan::default()
        }
    }
}

impl<'a> AssemblyPlan<'a> {
    /// The plan of a model on these cells.
    pub(super) fn on(mesh: &'a Mesh) -> Self {
        Self { mesh: Some(mesh), ..Self::default() }
    }

    /// All decisions about `scene`, with so much time `left` if that is limited.
    pub(super) fn decided(self, scene: &Scene, options: &Options, left: Option<Allowance>) -> Decisions<'a> {
        let visibility = self.visibility.map_or_else(
            || options.visibility(scene),
            |known| known.found_by(options.shadows, options.accuracy().shadow_eps),
        );
        let choice = self.choice.unwrap_or_else(|| TransportChoice::of(scene, options, left, || &visibility));
        let left = left.filter(|_| options.rays.is_none());
        let budget = || rays_in_time(options.ray_budget(scene), scene.surfaces.len(), left);
        let rays = choice.sampled.then(budget);
        let is_known = self.how.is_some();
        let Ground { how, mesh: own } = match self.how {
            Some(how) => Ground { how, mesh: None },
            None => ground(scene, &visibility, options, rays),
        };
        let is_refined = (self.mesh.is_some() && !is_known) || own.is_some();
        let mesh = self.mesh.map(Cow::Borrowed).or(own.map(Cow::Owned));
        Decisions { visibility, choice, rays, how, mesh, is_refined }
    }
}

impl Decisions<'_> {
    /// Bytes that the run takes at the most, estimated.
    pub(super) fn peak_memory(&self, scene: &Scene, options: &Options, ranks: &Ranks) -> u64 {
        match self.refined() {
            Some(mesh) => peak_of_mesh(scene, &self.how, mesh, options, ranks),
            None => self.need(scene, options, false, ranks).peak(),
        }
    }

    /// Refuses a run that needs more memory than allowed; else the bytes that it needs at the most, estimated. Its
    /// blocks and rays may be kept for the next scene.
    pub(super) fn require_memory(
        &self,
        scene: &Scene,
        options: &Options,
        is_kept: bool,
        ranks: &Ranks,
    ) -> Result<u64, Failure> {
        match self.refined() {
            Some(mesh) => require_memory_of_mesh(scene, &self.how, mesh, options, ranks),
            None => self.need(scene, options, is_kept, ranks).require(),
        }
    }

    /// The cells that do not follow from the cuts of surfaces.
    fn refined(&self) -> Option<&Mesh> {
        self.mesh.as_deref().filter(|_| self.is_refined)
    }

    fn need<'a>(
        &self,
        scene: &'a Scene,
        options: &'a Options,
        is_kept: bool,
        ranks: &'a Ranks,
    ) -> MemoryNeed<'a> {
        MemoryNeed { scene, how: self.how, options, rays: self.rays, is_kept, ranks }
    }
}

/// The cuts of the scene, given the rays that carry its pairs, if any: into elements that hold the functions
/// of the basis.
fn ground(scene: &Scene, visibility: &Visibility, options: &Options, rays: Option<u64>) -> Ground {
    let subdivide = match (options.subdivide, rays) {
        (None, Some(_)) if options.rays_of_pairs && are_many_flat(scene) => Subdivide::Uniform(1),
        (None, Some(rays)) => Subdivide::Graded { rays },
        _ => options.exact_cuts(visibility.any_shadow()),
    };
    let Options { basis, order, space, layers, eps, .. } = *options;
    basis.ground(scene, &Discretization { order, space, subdivide, layers }, eps)
}
