//! Runs that need more memory than allowed are refused, with what would fit.

use radiosity_elements::cells::Layers;
use radiosity_elements::mesh::Mesh;
use radiosity_elements::{Discretization, Subdivide, mesh_sizes};
use radiosity_scene::Scene;
use radiosity_solvers::method::Method;
use radiosity_work::ranks::Ranks;

use super::failure::Failure;
use super::memory_estimate::MemoryEstimate;
use super::memory_reduction::MemoryReduction;
use super::options::Options;
use super::pair_rays;

/// A run as far as its memory goes.
#[derive(Clone, Copy, Debug)]
pub(super) struct MemoryNeed<'a> {
    pub scene: &'a Scene,
    pub how: Discretization,
    pub options: &'a Options,
    /// Rays that carry its pairs, if any.
    pub rays: Option<u64>,
    /// Whether its blocks and rays are kept for the next scene.
    pub is_kept: bool,
    /// The ranks that share the run.
    pub ranks: &'a Ranks,
}

impl MemoryNeed<'_> {
    /// Most bytes that the run takes.
    pub(super) fn peak(&self) -> u64 {
        let Self { scene, how, options, ranks, .. } = self;
        let estimate = match self.rays {
            Some(rays) => {
                let estimate = MemoryEstimate::of_rays(scene, how, options.solver, rays, ranks);
                match pair_rays::memory(scene, options) {
                    Some(pairs) => estimate.by_pairs(pairs),
                    None => estimate,
                }
            }
            None if options.is_unsymmetric() => MemoryEstimate::unsymmetric(scene, how, options.solver),
            None => MemoryEstimate::of(scene, how, options.solver, ranks),
        };
        if self.is_kept { estimate.peak_with_kept() } else { estimate.peak() }
    }

    /// Refuses a run that needs more memory than allowed; else the bytes that it needs.
    pub(super) fn require(&self) -> Result<u64, Failure> {
        let needed = self.peak();
        let Some(allowed) = self.options.memory.filter(|allowed| needed > *allowed) else {
            return Ok(needed);
        };
        let mut fits = Vec::new();
        if self.is_kept && (Self { is_kept: false, ..*self }).peak() <= allowed {
            fits.push(MemoryReduction::FreshFrames);
        }
        match self.rays {
            Some(rays) => fits.extend(self.fewer_rays(rays, allowed)),
            None => fits.extend(self.less(allowed)),
        }
        Err(Failure::Memory { needed, allowed, fits })
    }

    /// Changes that let exact blocks fit into `allowed` bytes.
    fn less(&self, allowed: u64) -> Vec<MemoryReduction> {
        let Self { how, options, .. } = *self;
        let fits = |how, solver| {
            (MemoryNeed { how, options: &Options { solver, ..*options }, ..*self }).peak() <= allowed
        };
        let mut less = Vec::new();
        if fits(how, &Method::CG) {
            less.push(MemoryReduction::ConjugateGradients);
        }
        let lower =
            (0..how.order).rev().find(|order| fits(Discretization { order: *order, ..how }, options.solver));
        less.extend(lower.map(MemoryReduction::Order));
        let whole = Discretization { subdivide: Subdivide::Uniform(1), layers: Layers::NONE, ..how };
        if fits(whole, options.solver) {
            less.push(MemoryReduction::WholeSurfaces);
        }
        less
    }

    /// The half, quarter, … of the rays that would fit; elements follow from their number where nothing else
    /// is asked for.
    fn fewer_rays(&self, rays: u64, allowed: u64) -> Option<MemoryReduction> {
        let peak = |rays: u64| {
            let subdivide = match self.how.subdivide {
                Subdivide::Graded { .. } => Subdivide::Graded { rays },
                given => given,
            };
            (Self { rays: Some(rays), how: Discretization { subdivide, ..self.how }, ..*self }).peak()
        };
        let mut fewer = (1..u64::BITS).map(|halvings| rays >> halvings).take_while(|rays| *rays > 0);
        fewer.find(|rays| peak(*rays) <= allowed).map(MemoryReduction::Rays)
    }
}

/// Bytes that a run on elements of such a mesh takes at the most.
pub(super) fn peak_of_mesh(
    scene: &Scene,
    how: &Discretization,
    mesh: &Mesh,
    options: &Options,
    ranks: &Ranks,
) -> u64 {
    MemoryEstimate::of_sizes(scene, &mesh_sizes(scene, how, mesh), options.solver, ranks).peak()
}

/// Refuses a run on elements of a refined mesh that needs more memory than allowed; else the bytes that it needs.
pub(super) fn require_memory_of_mesh(
    scene: &Scene,
    how: &Discretization,
    mesh: &Mesh,
    options: &Options,
    ranks: &Ranks,
) -> Result<u64, Failure> {
    let needed = peak_of_mesh(scene, how, mesh, options, ranks);
    match options.memory {
        Some(allowed) if needed > allowed => Err(Failure::Memory { needed, allowed, fits: Vec::new() }),
        _ => Ok(needed),
    }
}
