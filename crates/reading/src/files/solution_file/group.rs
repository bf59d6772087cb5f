//! One light group in the file.

use radiosity_solve::solution::group_light::GroupLight;
use radiosity_solve::solution::powers::Powers;
use serde::{Deserialize, Serialize};

/// A light group, not dimmed; its coefficients stand with the elements.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct SavedGroup {
    /// Null for the light of surfaces without a group.
    pub(super) name: Option<String>,
    /// Relative residual of each band.
    pub(super) residuals: Vec<f64>,
    pub(super) powers: Powers,
}

impl SavedGroup {
    /// The file's entry of a solution's light group.
    pub(super) fn of(light: &GroupLight) -> Self {
        let residuals = light.bands.iter().map(|band| band.residual).collect();
        Self { name: light.group.clone(), residuals, powers: light.powers }
    }
}
