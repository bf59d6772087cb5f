//! Why a scene could not be solved hierarchically.

use radiosity_solvers::SolveError;

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
    #[error(
        "luminaire '{luminaire}': hierarchical radiosity carries the light of surfaces only: solve by the usual \
         method, --method galerkin"
    )]
    Luminaire {
        /// Name of the first luminaire that shines.
        luminaire: String,
    },
    /// Light of a sky, which links do not carry.
    #[error(
        "surface '{surface}' is an opening to a sky: hierarchical radiosity carries diffuse light only: solve by the usual \
         method, --method galerkin"
    )]
    Opening {
        /// Name of the first opening.
        surface: String,
    },
    /// A surface whose reflectance or emission varies, or that lets light through.
    #[error(
        "surface '{surface}' {what}: hierarchical radiosity takes surfaces for opaque and alike all over: solve by the usual method, \
         --method galerkin"
    )]
    Coating {
        /// Name of the first such surface.
        surface: String,
        /// What it does.
        what: &'static str,
    },
    /// The linear solver failed.
    #[error("band '{band}': {source}")]
    Solver {
        /// Name of the band.
        band: String,
        /// What the solver says.
        source: SolveError,
    },
}
