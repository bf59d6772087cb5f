//! Why a scene could not be solved hierarchically.

use radiosity_solvers::SolveError;
use radiosity_work::wording::{Wording, set, words};

/// Why a scene could not be solved hierarchically.
#[derive(Debug, thiserror::Error)]
pub enum HierarchyError {
    /// An option out of its range.
    #[error("{name} has to be {wanted}")]
    Option {
        /// Its name.
        name: &'static str,
        /// The range.
        wanted: &'static str,
    },
    /// Light of luminaires, which links do not carry.
    #[error("{}", self.message())]
    Luminaire {
        /// Name of the first luminaire that shines.
        luminaire: String,
    },
    /// Light of a sky, which links do not carry.
    #[error("{}", self.message())]
    Opening {
        /// Name of the first opening.
        surface: String,
    },
    /// A surface whose reflectance or emission varies, or that lets light through.
    #[error("{}", self.message())]
    Coating {
        /// Name of the first such surface.
        surface: String,
        /// Property that links do not carry, as a verb phrase: "lets light through".
        what: &'static str,
    },
    /// The linear solver failed.
    #[error("band '{band}': {source}")]
    Solver {
        /// Name of the band.
        band: String,
        /// Error of the solver.
        source: SolveError,
    },
}

impl HierarchyError {
    /// The fault and its cure, in words.
    pub fn message(&self) -> Wording {
        let fault = match self {
            Self::Luminaire { luminaire } => {
                format!("luminaire '{luminaire}': hierarchical radiosity carries the light of surfaces only")
            }
            Self::Opening { surface } => {
                format!(
                    "surface '{surface}' is an opening to a sky: hierarchical radiosity carries diffuse light only"
                )
            }
            Self::Coating { surface, what } => {
                format!(
                    "surface '{surface}' {what}: hierarchical radiosity takes surfaces for opaque and alike all over"
                )
            }
            Self::Option { .. } | Self::Solver { .. } => return words(self.to_string()),
        };
        words(fault) + ": solve by the usual method, " + set("method", "galerkin")
    }
}
