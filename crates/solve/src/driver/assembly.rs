//! The layout of a scene, what carries its pairs and how its surfaces are cut, and the blocks between its
//! elements.

use radiosity_elements::mesh::Mesh;
use radiosity_elements::{Discretization, Subdivide, usual_mesh};
use radiosity_kernel::Blocks;
use radiosity_published::bases::basis::Ground;
use radiosity_published::zatz1993::transfers;
use radiosity_scene::Scene;
use radiosity_transport as transport;
use radiosity_transport::{Demand, KeptBlocks};
use radiosity_visibility::Visibility;

use super::options::Options;
use super::sampling::{Sampling, Subject};
use super::transport_choice::TransportChoice;

/// The cuts of the scene, given the rays that carry its pairs, if any: into elements that hold the functions
/// of the basis.
pub(super) fn ground(scene: &Scene, visibility: &Visibility, options: &Options, rays: Option<u64>) -> Ground {
    let auto = || match rays {
        Some(rays) => Subdivide::Graded { rays },
        None => Subdivide::Auto { occluded: visibility.any_shadow() },
    };
    let subdivide = options.subdivide.map_or_else(auto, Subdivide::Uniform);
    let Options { basis, order, space, layers, eps, .. } = *options;
    basis.ground(scene, &Discretization { order, space, subdivide, layers }, eps)
}

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
        let visibility = Visibility::new(scene, options.into());
        let choice = TransportChoice::of(scene, options, || &visibility);
        let rays = choice.sampled.then(|| options.ray_budget(scene));
        let Ground { how, mesh } = ground(scene, &visibility, options, rays);
        Self { choice, how, mesh: mesh.unwrap_or_else(|| usual_mesh(scene, &how)) }
    }
}

/// The blocks, by that many rays or exactly; from `kept`, as far as it holds them.
pub(super) fn carried(
    scene: &Scene,
    subject: &Subject,
    rays: Option<u64>,
    kept: Option<&mut KeptBlocks>,
) -> (Blocks, Option<Sampling>) {
    if let Some(rays) = rays {
        let (blocks, sampling) = subject.sample(rays, kept);
        return (blocks, Some(sampling));
    }
    (blocks(scene, subject, kept), None)
}

fn blocks(scene: &Scene, subject: &Subject, kept: Option<&mut KeptBlocks>) -> Blocks {
    let Subject { elements, visibility, options, work, .. } = *subject;
    let Some(rules) = options.kernel else {
        let sends = |element: usize| scene.surfaces[elements.list()[element].surface].material.sends();
        let wanted = |a, b| sends(a) || sends(b);
        let demand = Demand::all(elements, visibility, options.accuracy()).of(&wanted);
        return transport::assemble(demand, kept, work);
    };
    let demand = Demand::all(elements, visibility, options.accuracy());
    transfers::assemble(demand, rules, rules.extra_points(), work)
}
