//! Requests for transfers without light, of view factors and of heat, and the library's options that follow.

use radiosity_heat::HeatOptions;
use radiosity_kernel::Accuracy;
use radiosity_solve::view_factors;
use radiosity_solve::{Options, Transport};
use radiosity_solvers::method::Method;
use radiosity_visibility::Shadows;
use radiosity_work::ranks::Ranks;
use radiosity_work::wording::{option, set, words};
use serde::Deserialize;

use super::conflicts::{asked_rays, refuse};
use super::memory;
use super::method::MethodRequest;
use super::modes::{self, LightShadows};
use super::ranges::{self, Bytes, Number, Order, Subdivide, by_text};
use super::refusal::Refusal;

/// Accuracy of view factors unless told otherwise.
const FACTORS: f64 = 1e-3;

/// Options of the integration of transfers; None where nothing is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct TransferRequest {
    /// Cuts each surface into K × K elements, which are summed: sharper shadows; auto looks at what the scene
    /// needs [default: auto]
    #[serde(deserialize_with = "by_text")]
    #[cfg_attr(feature = "clap", arg(long, value_name = "auto|K"))]
    pub subdivide: Option<Subdivide>,

    /// Accuracy of each factor, relative to itself or a hundredth of the largest of its row; to the largest
    /// of its row where rays carry it [default: 1e-3]
    #[cfg_attr(feature = "clap", arg(long, value_name = "E"))]
    pub eps: Option<Number<ranges::Accuracy>>,

    /// Accuracy of shadows [default: as --eps]
    #[cfg_attr(feature = "clap", arg(long, value_name = "E"))]
    pub shadow_eps: Option<Number<ranges::Accuracy>>,

    /// How it is found out what surfaces hide from each other [default: auto]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODE"))]
    pub shadows: Option<Shadows>,

    /// How the pairs of elements are carried [default: auto]
    #[cfg_attr(feature = "clap", arg(long, value_name = "MODE"))]
    pub transport: Option<Transport>,

    /// Rays of the sampled transport [default: by the number of surfaces and the accuracy]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub rays: Option<ranges::Rays>,

    /// Most memory to use, such as 500M, 2G or 2GiB [default: as much as it takes]
    #[serde(deserialize_with = "by_text")]
    #[cfg_attr(feature = "clap", arg(long, value_name = "BYTES"))]
    pub memory: Option<Bytes>,

    /// Threads to use, all by default; results do not depend on it
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub threads: Option<ranges::Threads>,
}

impl TransferRequest {
    /// The transfers of a method, as they are without light.
    ///
    /// # Errors
    /// Shadows that light alone has.
    pub fn of(method: &MethodRequest) -> Result<Self, Refusal> {
        let shadows = match method.shadows {
            None => None,
            Some(LightShadows::Found(shadows)) => Some(shadows),
            Some(LightShadows::Mask) => {
                return Err(Refusal::new(
                    set("shadows", "mask") + ": masks are of direct light",
                    words("leave ") + option("shadows") + " out",
                ));
            }
        };
        let MethodRequest { subdivide, eps, shadow_eps, transport, rays, memory, threads, .. } = *method;
        Ok(Self { subdivide, eps, shadow_eps, shadows, transport, rays, memory, threads })
    }

    /// Accuracies of view factors and their shadows.
    fn accuracy(&self) -> Accuracy {
        self.accuracy_or(FACTORS)
    }

    /// Accuracies of transfers and shadows; `usual` unless told otherwise.
    fn accuracy_or(&self, usual: f64) -> Accuracy {
        let eps = self.eps.map_or(usual, f64::from);
        Accuracy { eps, shadow_eps: self.shadow_eps.map_or(eps, f64::from) }
    }

    /// Number of threads to use, 0 for all.
    pub fn threads(&self) -> usize {
        self.threads.map_or(0, ranges::Threads::count)
    }

    /// Refuses rays where rules carry all pairs.
    fn check(&self) -> Result<(), Refusal> {
        let Some(rays) = asked_rays(self.transport, self.rays.is_some()) else { return Ok(()) };
        let others = [
            (self.transport == Some(Transport::Exact)).then(|| set("transport", "exact")),
            (self.shadows == Some(Shadows::Off)).then(|| set("shadows", "off")),
        ];
        refuse(rays, others)
    }

    /// The options of view factors.
    ///
    /// # Errors
    /// Rays where rules carry all pairs.
    pub fn factors(&self) -> Result<view_factors::Options, Refusal> {
        let usual = view_factors::Options::default();
        self.check()?;
        Ok(view_factors::Options {
            subdivide: self.subdivide.unwrap_or_default().0,
            accuracy: self.accuracy(),
            shadows: self.shadows.unwrap_or_default(),
            transport: self.transport.unwrap_or(usual.transport),
            rays: self.rays.map(u64::from),
            memory: self.memory.map(|Bytes(bytes)| bytes),
            threads: self.threads(),
        })
    }
}

/// Options of a balance of heat by transfers; None where nothing is said.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct HeatRequest {
    /// Degree of the polynomials on each element; 0 takes all fluxes as even over it, as thermal networks do, and as
    /// is done where rays carry the pairs [default: 3]
    #[cfg_attr(feature = "clap", arg(long, value_name = "N"))]
    pub order: Option<ranges::Degree>,

    /// Solver of the linear system [default: auto]
    #[serde(deserialize_with = "modes::solver")]
    #[cfg_attr(feature = "clap", arg(long, value_name = "NAME", value_parser = modes::solvers()))]
    pub solver: Option<&'static Method>,
}

impl HeatRequest {
    /// The balance of heat by a method.
    ///
    /// # Errors
    /// A degree that is to be found by the accuracy.
    pub fn of(method: &MethodRequest) -> Result<Self, Refusal> {
        let order = match method.order {
            None => None,
            Some(Order::Degree(degree)) => ranges::Degree::try_from(degree as i128).ok(),
            Some(Order::Auto) => {
                return Err(Refusal::new(
                    set("order", "auto") + ": heat is computed at one degree",
                    words("take a degree, such as ") + set("order", "5"),
                ));
            }
        };
        Ok(Self { order, solver: method.solver })
    }

    /// Degree of the polynomials that was asked for, if one was.
    pub fn asked_order(&self) -> Option<usize> {
        self.order.map(ranges::Degree::count)
    }

    /// Degree of the polynomials.
    fn order(&self) -> usize {
        self.order.map_or_else(|| HeatOptions::default().options.order, ranges::Degree::count)
    }

    /// The library's options of a balance by these transfers on these ranks, and whether `conductances` are
    /// computed.
    ///
    /// # Errors
    /// Rays where rules carry all pairs; rays that are asked for, which carry even fluxes, with a higher order.
    pub fn options(
        &self,
        transfers: &TransferRequest,
        conductances: bool,
        ranks: &Ranks,
    ) -> Result<HeatOptions, Refusal> {
        let usual = HeatOptions::default().options;
        transfers.check()?;
        if let Some(rays) = asked_rays(transfers.transport, transfers.rays.is_some()) {
            let order = self.asked_order().filter(|order| *order > 0);
            refuse(rays, [order.map(|order| set("order", order))])?;
        }
        let Accuracy { eps, shadow_eps } = transfers.accuracy_or(usual.eps);
        let options = Options {
            order: self.order(),
            subdivide: transfers.subdivide.unwrap_or_default().0,
            eps,
            shadow_eps,
            shadows: transfers.shadows.unwrap_or_default(),
            transport: transfers.transport.unwrap_or(usual.transport),
            rays: transfers.rays.map(u64::from),
            solver: self.solver.unwrap_or(usual.solver),
            memory: memory::allowed(transfers.memory, ranks),
            threads: transfers.threads(),
            ..usual
        };
        Ok(HeatOptions { options, conductances })
    }
}
