//! Why the heat of a scene has no balance.

use radiosity_solve::Failure;
use radiosity_work::listed::{SPELT, listed};
use radiosity_work::wording::{Wording, option, words};

/// Why the heat of a scene has no balance.
#[derive(Debug, thiserror::Error)]
pub enum HeatError {
    /// Surfaces of which neither temperature nor flux is known.
    #[error("neither a temperature nor a flux of heat is given for {}", listed(surfaces, SPELT))]
    NoCondition {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
    /// Surfaces that need an emissivity.
    #[error("no emissivity is given for {}", listed(surfaces, SPELT))]
    NoEmissivity {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
    /// Surfaces that let heat through.
    #[error("heat would pass through {}", listed(surfaces, SPELT))]
    Transmits {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
    /// Surfaces that exchange heat with one another alone, all of known flux.
    #[error(
        "no temperature sets the level of {}: nothing but fluxes of heat is given, and no more can leave than the transfers err by",
        listed(surfaces, SPELT)
    )]
    NoLevel {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
    /// Surfaces from which more heat is drawn than arrives.
    #[error("more heat is drawn than arrives: no temperature is low enough for {}", listed(surfaces, SPELT))]
    TooCold {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
    /// Conductances for which memory does not suffice.
    #[error(
        "not enough memory: the conductances between {surfaces} surfaces need about {:.0} MB, {:.0} MB allowed",
        *needed as f64 / 1e6, *allowed as f64 / 1e6
    )]
    Conductances {
        /// Number of surfaces.
        surfaces: usize,
        /// Bytes needed, estimated.
        needed: u64,
        /// Bytes allowed.
        allowed: u64,
    },
    /// The radiosity could not be computed.
    #[error(transparent)]
    Solve(#[from] Failure),
}

impl HeatError {
    /// Cure of the error; None where the message already states it.
    pub fn cure(&self) -> Option<Wording> {
        Some(match self {
            Self::NoCondition { .. } => words(
                "give the surface or its material temperature = …, in kelvin, heat_flux = …, in W/m², or adiabatic = true",
            ),
            Self::NoEmissivity { .. } => words("give the material emissivity = …, 0 < ε ≤ 1"),
            Self::Transmits { .. } => {
                words("leave the transmittance of the material out: the surfaces of radiant heat are opaque")
            }
            Self::NoLevel { .. } => {
                words(
                    "give one of them a temperature; heat that leaves by a small opening is found by a smaller ",
                ) + option("eps")
            }
            Self::TooCold { .. } => {
                words("draw less heat, a heat_flux nearer to 0, or give a temperature instead")
            }
            Self::Conductances { .. } => {
                words("take a lower ")
                    + option("order")
                    + ", leave out "
                    + option("conductances")
                    + ", or allow more with "
                    + option("memory")
            }
            Self::Solve(failure) => return failure.cure(),
        })
    }
}
