//! Requests for transfers without light, of view factors and of heat, and the library's options that follow.

use radiosity_heat::HeatOptions;
use radiosity_kernel::Accuracy;
use radiosity_solve::view_factors;
use radiosity_solve::{Options, Transport};
use radiosity_solvers::method::Method;
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::set;

use super::memory;
use super::modes::Shadows;
use super::refusal::Refusal;

/// Request for the integration of transfers; None where nothing was said.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransferRequest {
    /// Cuts each surface into K × K elements, which are summed; None chooses.
    pub subdivide: Option<usize>,
    /// Relative accuracy of each factor.
    pub eps: f64,
    /// Relative accuracy of shadows; None for that of factors.
    pub shadow_eps: Option<f64>,
    /// Method that finds out whether surfaces hide each other.
    pub shadows: Shadows,
    /// Number of threads; None for all.
    pub threads: Option<usize>,
}

impl TransferRequest {
    /// Accuracy of view factors unless told otherwise.
    pub const FACTORS: f64 = 1e-3;

    /// Accuracy of the transfers of heat unless told otherwise.
    pub const HEAT: f64 = 1e-4;

    /// The usual request with the accuracy `eps`.
    pub fn new(eps: f64) -> Self {
        Self { subdivide: None, eps, shadow_eps: None, shadows: Shadows::Auto, threads: None }
    }

    /// Relative accuracies of factors and of shadows.
    pub fn accuracy(&self) -> Accuracy {
        Accuracy { eps: self.eps, shadow_eps: self.shadow_eps.unwrap_or(self.eps) }
    }

    /// Number of threads to use, 0 for all.
    pub fn threads(&self) -> usize {
        self.threads.unwrap_or(0)
    }

    /// Refuses masks, which carry light.
    ///
    /// # Errors
    /// If they were asked for.
    pub fn check(&self) -> Result<(), Refusal> {
        if self.shadows != Shadows::Mask {
            return Ok(());
        }
        Err(Refusal::new(
            set("shadows", "mask") + ": masks carry light of lamps, and there is none here",
            "choose auto, exact, rays or off",
        ))
    }

    /// The options of view factors.
    pub fn factors(&self) -> view_factors::Options {
        view_factors::Options {
            subdivide: self.subdivide,
            accuracy: self.accuracy(),
            shadows: self.shadows.hiding(),
            threads: self.threads(),
        }
    }
}

/// Request for a balance of heat.
#[derive(Clone, Copy, Debug)]
pub struct HeatRequest {
    /// Integration of transfers.
    pub transfers: TransferRequest,
    /// Degree of the polynomials on each element.
    pub order: usize,
    /// Transport of radiation between pairs of elements.
    pub transport: Transport,
    /// Solver of the linear system.
    pub solver: &'static Method,
    /// Most bytes of memory; None for 80 % of what is free.
    pub memory: Option<u64>,
    /// Whether conductances are computed.
    pub conductances: bool,
}

impl Default for HeatRequest {
    fn default() -> Self {
        let HeatOptions { options, conductances } = HeatOptions::default();
        let transfers = TransferRequest::new(TransferRequest::HEAT);
        let Options { order, transport, solver, .. } = options;
        Self { transfers, order, transport, solver, memory: None, conductances }
    }
}

impl HeatRequest {
    /// The library's options of a balance of heat on these ranks.
    pub fn options(&self, ranks: &Ranks) -> HeatOptions {
        let usual = HeatOptions::default().options;
        let Accuracy { eps, shadow_eps } = self.transfers.accuracy();
        let options = Options {
            order: self.order,
            subdivide: self.transfers.subdivide,
            eps,
            shadow_eps,
            shadows: self.transfers.shadows.hiding(),
            transport: self.transport,
            solver: self.solver,
            memory: self.memory.or_else(|| memory::usable(ranks)),
            threads: self.transfers.threads(),
            ..usual
        };
        HeatOptions { options, conductances: self.conductances }
    }
}
