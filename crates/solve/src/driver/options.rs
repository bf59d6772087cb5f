//! Options of a solution.

use radiosity_elements::Subdivide;
use radiosity_elements::cells::Layers;
use radiosity_elements::space::Space;
use radiosity_kernel::Accuracy;
use radiosity_published::bases::Basis;
use radiosity_published::zatz1993::masking::Masking;
use radiosity_published::zatz1993::transfers;
use radiosity_scene::Scene;
use radiosity_solvers::method::Method;
use radiosity_visibility::{Shadows, Visibility};
use radiosity_work::ranks::Ranks;
use serde::{Deserialize, Serialize};

use super::column_choice::ColumnChoice;
use super::direct::Direct;
use super::failure::Failure;
use super::in_threads::in_threads;
use super::light_method::LightMethod;
use super::linking::Linking;
use super::preconditioning::Preconditioning;
use super::relaxing::Relaxing;
use super::shots::ShotLimit;
use super::transport_choice::{MOST_RAYS, Transport, usual_rays};

/// Options of a solution: method, elements, accuracies, solver and means.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Options {
    /// The method that finds the light. The hierarchical one takes of all others `eps`, `linking`, the solver
    /// and the threads.
    #[serde(default)]
    pub method: LightMethod,
    /// The functions that are summed: polynomials, or one of the bases of the variational form (Szirmay-Kalos
    /// 1996).
    #[serde(default)]
    pub basis: Basis,
    /// Order of the basis where a surface does not state its own.
    pub order: usize,
    /// The polynomials of that order: of total degree, or of that degree in each coordinate.
    pub space: Space,
    /// Cuts along u and v of surfaces that do not state their own; None chooses.
    pub subdivide: Option<usize>,
    /// Further cuts of the outermost cells of every surface, towards its sides.
    pub layers: Layers,
    /// Whether exact blocks take layers at the sides of surfaces that others face from near by, where neither cuts nor
    /// layers are given.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub near_layers: bool,
    /// Accuracy of the kernel blocks; by links, the greatest power or form factor of one.
    pub eps: f64,
    /// The links of the hierarchical method.
    #[serde(default, skip_serializing_if = "Linking::is_usual")]
    pub linking: Linking,
    /// The rules of 1993 instead of those that keep `eps`.
    pub kernel: Option<transfers::PaperRules>,
    /// Carriers of pairs of elements.
    pub transport: Transport,
    /// Rays of the sampled transport; None: as many as the scene and the accuracy of shadows need.
    pub rays: Option<u64>,
    /// Whether each pair has rays of its own, where rays carry the pairs of many small flat elements of constants.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub rays_of_pairs: bool,
    /// Multiple of that number, where it is chosen.
    #[serde(default = "once", skip_serializing_if = "is_once")]
    pub finer_rays: u64,
    /// Accuracy of visibility within a block.
    pub shadow_eps: f64,
    /// Ways to find shadows between surfaces.
    pub shadows: Shadows,
    /// Masking of direct light, as polynomials times shadow masks; None treats it as `direct` says.
    pub masks: Option<Masking>,
    /// The way in which direct light enters the solution.
    pub direct: Direct,
    /// The solver of the system of a band.
    #[serde(with = "solver_name")]
    pub solver: &'static Method,
    /// Preconditioner of cg and gmres.
    #[serde(default)]
    pub preconditioner: Preconditioning,
    /// Ways of solvers that relax, and of gmres.
    #[serde(default, skip_serializing_if = "Relaxing::is_usual")]
    pub relaxing: Relaxing,
    /// When columns of G are integrated for a solver that shoots; None: each when it is first shot, where
    /// that can be.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub columns: Option<ColumnChoice>,
    /// Shots after which the light of a solver that shoots is taken as it is; None for all that its tolerance
    /// takes. Solution files hold all light.
    #[serde(skip)]
    pub shots: Option<ShotLimit>,
    /// Light that was reflected so many times at the most before it arrives, by the Galerkin method to no
    /// wanted accuracy; None for all. Solution files hold all light.
    #[serde(skip)]
    pub bounces: Option<usize>,
    /// Relative residual ‖r‖₂/‖b‖₂ of the linear solve.
    pub tolerance: f64,
    /// Most iterations of the linear solve.
    pub max_iterations: usize,
    /// Whether the best iterate counts as a solution if the solver does not converge.
    pub keep_partial: bool,
    /// Most bytes to use ([`MemoryEstimate`](crate::driver::memory_estimate::MemoryEstimate)); a run that
    /// needs more is refused before it begins.
    #[serde(skip)]
    pub memory: Option<u64>,
    /// Threads, 0 for all that a rank may use; the result does not depend on it.
    #[serde(skip)]
    pub threads: usize,
}

impl Default for Options {
    /// Order 3, blocks to 1e-3, shadows to 3e-3, direct light and solver as the scene needs, all threads.
    fn default() -> Self {
        Self {
            method: LightMethod::Galerkin,
            basis: Basis::Legendre,
            order: 3,
            space: Space::Total,
            subdivide: None,
            layers: Layers::NONE,
            near_layers: false,
            eps: 1e-3,
            linking: Linking::default(),
            kernel: None,
            transport: Transport::Auto,
            rays: None,
            rays_of_pairs: false,
            finer_rays: once(),
            shadow_eps: 3e-3,
            shadows: Shadows::Auto,
            masks: None,
            direct: Direct::Auto,
            solver: &Method::AUTO,
            preconditioner: Preconditioning::Block,
            relaxing: Relaxing::default(),
            columns: None,
            shots: None,
            bounces: None,
            tolerance: 1e-8,
            max_iterations: 1000,
            keep_partial: false,
            memory: None,
            threads: 0,
        }
    }
}

impl Options {
    /// Accuracy of the blocks.
    pub fn accuracy(&self) -> Accuracy {
        Accuracy { eps: self.eps, shadow_eps: self.shadows.accuracy(self.eps, self.shadow_eps) }
    }

    /// The cuts of surfaces for exact blocks; `occluded` where anything can cast a shadow.
    pub(crate) fn exact_cuts(&self, occluded: bool) -> Subdivide {
        let auto = Subdivide::Auto { occluded, near_layers: self.near_layers };
        self.subdivide.map_or(auto, Subdivide::Uniform)
    }

    /// Whether each ordered pair of elements is integrated by itself, as published methods do.
    pub(crate) fn is_unsymmetric(&self) -> bool {
        self.kernel.is_some() || self.method == LightMethod::Collocation
    }

    /// The obstacles of `scene`, as it is solved by these options, and read.
    pub fn visibility(&self, scene: &Scene) -> Visibility {
        Visibility::new(scene, self.shadows, self.accuracy().shadow_eps)
    }
}

impl Options {
    /// These options with the usual ones for all that changes no bit of a result: threads, memory, and what
    /// counts as a solution.
    pub fn neutral(&self) -> Self {
        Self { threads: 0, memory: None, keep_partial: false, ..*self }
    }

    /// These options with the usual ones for all that no block depends on.
    pub(crate) fn of_transfers(&self) -> Self {
        let Options { solver, preconditioner, relaxing, columns, tolerance, max_iterations, .. } =
            Self::default();
        let neutral = Self { shots: None, bounces: None, linking: Linking::default(), ..self.neutral() };
        Self { solver, preconditioner, relaxing, columns, tolerance, max_iterations, ..neutral }
    }

    /// Does `work` with the threads of these options on one of these ranks, as [`in_threads`].
    ///
    /// # Errors
    /// Threads that cannot be started.
    pub fn in_threads<T: Send>(&self, ranks: &Ranks, work: impl FnOnce() -> T + Send) -> Result<T, Failure> {
        in_threads(ranks.threads(self.threads), work)
    }

    /// Rays of the sampled transport of `scene`.
    pub(crate) fn ray_budget(&self, scene: &Scene) -> u64 {
        let usual =
            || self.finer_rays.saturating_mul(usual_rays(scene.surfaces.len(), self.accuracy().shadow_eps));
        self.rays.unwrap_or_else(usual).min(MOST_RAYS)
    }
}

fn once() -> u64 {
    1
}

fn is_once(factor: &u64) -> bool {
    *factor == once()
}

/// A solver, (de)serialised by its name.
mod solver_name {
    use radiosity_solvers::method::Method;
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    pub(super) fn serialize<S: Serializer>(method: &Method, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(method.name)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<&'static Method, D::Error> {
        Method::named(&String::deserialize(from)?).map_err(D::Error::custom)
    }
}
