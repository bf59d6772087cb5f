//! The blocks between the elements of a scene.

use radiosity_kernel::Blocks;
use radiosity_published::{collocation, zatz1993::transfers};
use radiosity_scene::Scene;
use radiosity_transport as transport;
use radiosity_transport::Demand;

use super::kept_model::KeptModel;
use super::light_method::LightMethod;
use super::sampling::Sampling;
use super::subject::Subject;

/// The blocks, by that many rays or exactly; from `kept`, as far as it holds them.
pub(super) fn carried(
    scene: &Scene,
    subject: &Subject,
    rays: Option<u64>,
    kept: Option<&mut KeptModel>,
) -> (Blocks, Option<Sampling>) {
    if let Some(rays) = rays {
        let by_pairs = if kept.is_none() { subject.sample_pairs() } else { None };
        if let Some((blocks, sampling)) = by_pairs {
            return (blocks, Some(sampling));
        }
        let (blocks, sampling) = subject.sample(rays, kept);
        return (blocks, Some(sampling));
    }
    (blocks(scene, subject, kept), None)
}

fn blocks(scene: &Scene, subject: &Subject, kept: Option<&mut KeptModel>) -> Blocks {
    let Subject { elements, visibility, options, work, .. } = *subject;
    let all = Demand::all(elements, visibility, options.accuracy());
    if let Some(rules) = options.kernel {
        return transfers::assemble(all, rules, rules.extra_points(), work);
    }
    let sends = |element: usize| scene.surfaces[elements.list()[element].surface].material.sends();
    let wanted = |a, b| sends(a) || sends(b);
    let demand = all.of(&wanted);
    match options.method {
        LightMethod::Collocation => collocation::assemble(demand, work),
        LightMethod::Galerkin | LightMethod::Hierarchical => {
            transport::assemble(demand, kept.map(|kept| &mut kept.blocks), work)
        }
    }
}
