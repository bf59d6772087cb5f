//! Why heat cannot be read by walks.

use radiosity_work::listed::quoted;
use radiosity_work::wording::{Wording, words};

/// Why the heat of a scene cannot be read by walks.
#[derive(Debug, thiserror::Error)]
pub enum HeatFault {
    /// Surfaces of which neither temperature nor flux is known.
    #[error("neither a temperature nor a flux of heat is known of {}", quoted(surfaces))]
    NoCondition {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
    /// Surfaces that need an emissivity.
    #[error("no emissivity is known of {}", quoted(surfaces))]
    NoEmissivity {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
    /// Surfaces that let heat through.
    #[error("heat would pass through {}", quoted(surfaces))]
    Transmits {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
    /// Surfaces from which no heat gets to a known temperature or out of the scene.
    #[error(
        "no walk ends that starts at {}: all that it meets has a known flux and none leaves",
        quoted(surfaces)
    )]
    NoLevel {
        /// Names of the surfaces.
        surfaces: Vec<String>,
    },
}

impl HeatFault {
    /// Cure of the fault.
    pub fn cure(&self) -> Wording {
        words(match self {
            Self::NoCondition { .. } => {
                "give the surface or its material temperature = …, in kelvin, heat_flux = …, in W/m², or adiabatic = true"
            }
            Self::NoEmissivity { .. } => "give the material emissivity = …, 0 < ε ≤ 1",
            Self::Transmits { .. } => {
                "leave the transmittance of the material out: heat meets opaque surfaces"
            }
            Self::NoLevel { .. } => "give one of them a temperature",
        })
    }
}
