//! The blocks between the elements of a scene.

use radiosity_kernel::Blocks;
use radiosity_published::zatz1993::transfers;
use radiosity_scene::Scene;
use radiosity_transport as transport;
use radiosity_transport::{Demand, KeptBlocks};

use super::sampling::{Sampling, Subject};

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
