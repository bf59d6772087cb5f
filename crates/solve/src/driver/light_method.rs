//! The method that finds the light.

use serde::{Deserialize, Serialize};

/// Methods that find the light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum LightMethod {
    /// Polynomials on elements, with transfers between all of them
    #[default]
    Galerkin,
    /// As galerkin, but light that arrives is right at points of each element, and interpolated between them,
    /// instead of right in the mean: for those who compare
    Collocation,
    /// Constants on elements that the light asks for, with links between groups of them: hierarchical
    /// radiosity, for those who compare; --eps is the greatest power of a link, or form factor
    Hierarchical,
}
