//! The layout of a scene: what carries its pairs, and the cuts of its surfaces.

use radiosity_elements::mesh::Mesh;
use radiosity_elements::{Discretization, usual_mesh};
use radiosity_published::bases::basis::Ground;
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;

use super::assembly::ground;
use super::options::Options;
use super::transport_choice::TransportChoice;

/// The carrier of the pairs of a scene, and the cuts of its surfaces. Scenes that differ only in the places
/// of some things share a layout: what carries the light of things that turn does not depend on how they
/// stand to the axes.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    pub(super) choice: TransportChoice,
    pub(super) how: Discretization,
    pub(super) mesh: Mesh,
}

impl Layout {
    /// Whether rays carry the pairs.
    pub(crate) fn is_by_rays(&self) -> bool {
        self.choice.sampled
    }

    /// The layout of `scene` by these options.
    pub(crate) fn of(scene: &Scene, options: &Options) -> Self {
        let choice = TransportChoice::of(scene, options);
        let rays = choice.sampled.then(|| options.ray_budget(scene));
        let Ground { how, mesh } = ground(scene, &Visibility::new(scene, options.into()), options, rays);
        Self { choice, how, mesh: mesh.unwrap_or_else(|| usual_mesh(scene, &how)) }
    }
}
