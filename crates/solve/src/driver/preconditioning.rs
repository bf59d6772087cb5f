//! Preconditioners of cg and gmres.

use radiosity_solvers::Preconditioner;
use serde::{Deserialize, Serialize};

/// Matrices that cg and gmres multiply residuals by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum Preconditioning {
    /// The inverses of the diagonal blocks (block Jacobi): the identity for elements that do not see
    /// themselves
    #[default]
    Block,
    /// Nothing
    None,
}

impl From<Preconditioning> for Preconditioner {
    fn from(own: Preconditioning) -> Self {
        match own {
            Preconditioning::Block => Self::Block,
            Preconditioning::None => Self::None,
        }
    }
}
