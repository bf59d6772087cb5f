//! Memory that a solution asks for.

use radiosity::elements::{Discretization, Subdivide};
use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity::solve::driver::memory_estimate::MemoryEstimate;
use radiosity::work::ranks::Ranks;

/// Megabytes as reckoned before the run, whole surfaces being elements.
pub(crate) fn megabytes(scene: &Scene, options: &Options) -> f64 {
    let Options { order, space, layers, solver: method, .. } = *options;
    let how = Discretization { order, space, subdivide: Subdivide::Uniform(1), layers };
    MemoryEstimate::of(scene, &how, method, Ranks::alone()).peak() as f64 / 1e6
}
