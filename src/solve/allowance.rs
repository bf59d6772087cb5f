//! Runs that need more memory than allowed are refused, with what would fit.

use radiosity_solvers::method::Method;

use crate::elements::cells::Layers;
use crate::elements::mesh::Mesh;
use crate::elements::{Discretization, Subdivide, mesh_sizes};
use crate::scene::Scene;

use super::failure::Failure;
use super::fit::Fit;
use super::memory::Footprint;
use super::options::Options;

/// Bytes that a run takes at the most, by that many rays if any.
pub(super) fn peak_memory(scene: &Scene, how: &Discretization, options: &Options, rays: Option<u64>) -> u64 {
    match rays {
        Some(rays) => Footprint::of_rays(scene, how, options.method, rays).peak(),
        None if options.kernel.is_some() => Footprint::of_1993(scene, how, options.method).peak(),
        None => Footprint::of(scene, how, options.method).peak(),
    }
}

/// Refuses a run that needs more memory than allowed.
pub(super) fn require_memory(
    scene: &Scene,
    how: &Discretization,
    options: &Options,
    rays: Option<u64>,
) -> Result<(), Failure> {
    let Some(allowed) = options.memory else { return Ok(()) };
    if let Some(rays) = rays {
        return require_memory_of_rays(scene, how, options.method, rays, allowed);
    }
    let peak = |how: &Discretization, method| peak_memory(scene, how, &Options { method, ..*options }, None);
    let needed = peak(how, options.method);
    if needed <= allowed {
        return Ok(());
    }
    let mut fits = Vec::new();
    let cg = Method::named("cg").expect("cg is always listed");
    if peak(how, cg) <= allowed {
        fits.push(Fit::ConjugateGradients);
    }
    let lower = (0..how.order)
        .rev()
        .find(|order| peak(&Discretization { order: *order, ..*how }, options.method) <= allowed);
    fits.extend(lower.map(Fit::Order));
    let whole = Discretization { subdivide: Subdivide::Uniform(1), layers: Layers::NONE, ..*how };
    if peak(&whole, options.method) <= allowed {
        fits.push(Fit::WholeSurfaces);
    }
    Err(Failure::Memory { needed, allowed, fits })
}

/// Refuses a run on elements of a refined mesh that needs more memory than allowed.
pub(super) fn require_memory_of_mesh(
    scene: &Scene,
    how: &Discretization,
    mesh: &Mesh,
    options: &Options,
) -> Result<(), Failure> {
    let Some(allowed) = options.memory else { return Ok(()) };
    let needed = Footprint::of_sizes(scene, &mesh_sizes(scene, how, mesh), options.method).peak();
    if needed <= allowed { Ok(()) } else { Err(Failure::Memory { needed, allowed, fits: Vec::new() }) }
}

/// The same for the sampled transport, whose elements follow from the number of rays where nothing else is asked for.
fn require_memory_of_rays(
    scene: &Scene,
    how: &Discretization,
    method: &Method,
    rays: u64,
    allowed: u64,
) -> Result<(), Failure> {
    let peak = |rays: u64| {
        let subdivide = match how.subdivide {
            Subdivide::Graded { .. } => Subdivide::Graded { rays },
            given => given,
        };
        Footprint::of_rays(scene, &Discretization { subdivide, ..*how }, method, rays).peak()
    };
    let needed = peak(rays);
    if needed <= allowed {
        return Ok(());
    }
    let fewer = (1..u64::BITS).map(|halvings| rays >> halvings).take_while(|rays| *rays > 0);
    let fits = fewer.filter(|rays| peak(*rays) <= allowed).take(1).map(Fit::Rays).collect();
    Err(Failure::Memory { needed, allowed, fits })
}
