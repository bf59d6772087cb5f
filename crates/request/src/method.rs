//! Requests for the computation of light, and the library's options that follow.

use std::time::{Duration, Instant};

use radiosity_elements::cells::Layers;
use radiosity_elements::space::Space;
use radiosity_published::bases::Basis;
use radiosity_published::zatz1993::masked_light::Masking;
use radiosity_reading::quality::Quality;
use radiosity_solve::studies::adaptation::Aim;
use radiosity_solve::{Direct, LightMethod, Options, Preconditioning, Transport};
use radiosity_solvers::method::Method;
use radiosity_work::ranks::Ranks;

use super::memory;
use super::modes::{Kernel, Order, Shadows};

/// The accuracy that `--order auto` means. Chosen.
const AUTO_ACCURACY: f64 = 1e-2;

/// Request for the computation of light; None where nothing was said. Numbers are in their
/// [ranges](super::ranges).
#[derive(Clone, Debug)]
pub struct MethodRequest {
    /// Preset of order, accuracies and points read.
    pub quality: Quality,
    /// Method that finds the light.
    pub method: LightMethod,
    /// Functions whose sums the light on surfaces is.
    pub basis: Basis,
    /// Degree of the polynomials on each element.
    pub order: Option<Order>,
    /// Wanted relative error, above 0 and below 1.
    pub accuracy: Option<f64>,
    /// Quantity that the accuracy is wanted of.
    pub aim: Option<Aim>,
    /// Time (s) after which no finer run begins.
    pub time_limit: Option<f64>,
    /// Whether the polynomials are of that degree in each coordinate, not in total.
    pub tensor: bool,
    /// Cuts each surface into K × K elements; None chooses.
    pub subdivide: Option<usize>,
    /// Graded layers of elements.
    pub layers: Layers,
    /// Relative accuracy of the transfers.
    pub eps: Option<f64>,
    /// Rules of the transfers.
    pub kernel: Kernel,
    /// Transport of light between pairs of elements.
    pub transport: Transport,
    /// Number of rays of the sampled transport.
    pub rays: Option<u64>,
    /// Solver of the linear system.
    pub solver: &'static Method,
    /// Preconditioner of cg and gmres.
    pub preconditioner: Preconditioning,
    /// Light that was reflected so many times at the most before it arrives; None for all.
    pub bounces: Option<usize>,
    /// Relative residual at which an iterative solver stops.
    pub tolerance: f64,
    /// Iterations after which an iterative solver gives up.
    pub max_iterations: usize,
    /// Method that finds out whether surfaces hide each other.
    pub shadows: Shadows,
    /// Treatment of light that comes straight from emitters.
    pub direct: Direct,
    /// Relative accuracy of shadows.
    pub shadow_eps: Option<f64>,
    /// Cells and averages of shadow masks, with [`Shadows::Mask`].
    pub masks: Masking,
    /// Most bytes of memory; None for 80 % of what is free.
    pub memory: Option<u64>,
    /// Number of threads; None for all.
    pub threads: Option<usize>,
}

impl Default for MethodRequest {
    fn default() -> Self {
        let usual = Options::default();
        Self {
            quality: Quality::Default,
            method: usual.method,
            basis: usual.basis,
            order: None,
            accuracy: None,
            aim: None,
            time_limit: None,
            tensor: false,
            subdivide: None,
            layers: Layers::NONE,
            eps: None,
            kernel: Kernel::Default,
            transport: usual.transport,
            rays: None,
            solver: usual.solver,
            preconditioner: usual.preconditioner,
            bounces: None,
            tolerance: usual.tolerance,
            max_iterations: usual.max_iterations,
            shadows: Shadows::Auto,
            direct: usual.direct,
            shadow_eps: None,
            masks: Masking::default(),
            memory: None,
            threads: None,
        }
    }
}

impl MethodRequest {
    /// The relative error wanted, if one is.
    pub fn wanted_accuracy(&self) -> Option<f64> {
        self.accuracy.or_else(|| (self.order == Some(Order::Auto)).then_some(AUTO_ACCURACY))
    }

    /// The library's options on these ranks.
    pub fn options(&self, ranks: &Ranks) -> Options {
        let usual = self.quality.options();
        Options {
            method: self.method,
            basis: self.basis,
            order: self.degree(usual.order),
            space: if self.tensor { Space::Tensor } else { Space::Total },
            subdivide: self.subdivide,
            layers: self.layers,
            eps: self.eps.unwrap_or(usual.eps),
            kernel: self.kernel.rules(),
            transport: self.transport,
            rays: self.rays,
            shadow_eps: self.shadow_eps.or(self.eps).unwrap_or(usual.shadow_eps),
            shadows: self.shadows.hiding(),
            masks: (self.shadows == Shadows::Mask).then_some(self.masks),
            direct: self.direct,
            solver: self.solver,
            preconditioner: self.preconditioner,
            bounces: self.bounces,
            tolerance: self.tolerance,
            max_iterations: self.max_iterations,
            memory: self.memory.or_else(|| memory::usable(ranks)),
            threads: self.threads.unwrap_or(usual.threads),
            ..usual
        }
    }

    /// The degree to begin with.
    fn degree(&self, usual: usize) -> usize {
        match (self.basis, self.order) {
            (Basis::Constant, _) => 0,
            (Basis::Linear, _) => 1,
            (_, Some(Order::Degree(order))) => order,
            (_, None) if self.wanted_accuracy().is_none() => usual,
            (_, Some(Order::Auto) | None) => 0,
        }
    }

    /// Time at which the time limit ends, from now on; none without a limit.
    pub fn deadline(&self) -> Option<Instant> {
        let limit = Duration::try_from_secs_f64(self.time_limit?).ok()?;
        Instant::now().checked_add(limit)
    }
}
