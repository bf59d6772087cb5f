//! Options of hierarchical radiosity: links, visibility and solver.

use radiosity_solvers::method::Method;
use serde::{Deserialize, Serialize};

/// Measure of a pair of nodes that is compared with `eps`: if it is more, the pair is not linked but refined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum LinkMeasure {
    /// The power that one end sends to the other, in parts of all that the scene emits: the form factor times
    /// area and brightness
    #[default]
    Power,
    /// The form factor alone, dark or bright, as Hanrahan, Salzman and Aupperle (1991) begin
    FormFactor,
}

/// Options of hierarchical radiosity.
#[derive(Clone, Copy, Debug)]
pub struct HierarchyOptions {
    /// The measure that is compared with `eps`.
    pub measure: LinkMeasure,
    /// Greatest power (in parts of the power that the scene emits) or form factor of a link that is not
    /// refined, and greatest difference of the form factors of a face and of its cells under one link; above
    /// 0.
    pub eps: f64,
    /// Faces up to this part of the area of all surfaces are not cut; above 0.
    pub least_area: f64,
    /// Least distance of the centres of two linked nodes of which one is a cluster, in sums of their radii;
    /// at least 1.
    pub separation: f64,
    /// Most rounds of refinement; at least 1.
    pub rounds: usize,
    /// Rays that find the visibility of a link; at least 1.
    pub rays_per_link: usize,
    /// Solver of the linear system.
    pub solver: &'static Method,
    /// Relative residual of the solver.
    pub tolerance: f64,
}

impl Default for HierarchyOptions {
    /// Links of 1e-4 of the power, faces of 1e-5 of the area, balls half a sum of radii apart, eight rounds,
    /// sixteen rays, conjugate gradients to 1e-8.
    fn default() -> Self {
        Self {
            measure: LinkMeasure::Power,
            eps: 1e-4,
            least_area: 1e-5,
            separation: 1.5,
            rounds: 8,
            rays_per_link: 16,
            solver: &Method::CG,
            tolerance: 1e-8,
        }
    }
}
