//! `--set` of `heat`: parameters of a scene, and quantities of heat of its surfaces.

use radiosity_scene::{Fault, HeatSetting};

/// One thing that is set.
#[derive(Debug)]
pub(super) enum Setting {
    /// A parameter, a variable or a light group.
    Parameter { name: String, value: f64 },
    /// A quantity of heat.
    Heat { quantity: HeatSetting, value: f64 },
}

impl Setting {
    /// The setting of this name: with a key behind a point it is a quantity of heat.
    ///
    /// # Errors
    /// A key of no quantity.
    pub(super) fn of(name: &str, value: f64) -> Result<Self, Fault> {
        match name.contains('.') {
            true => Ok(Self::Heat { quantity: HeatSetting::named(name)?, value }),
            false => Ok(Self::Parameter { name: name.to_owned(), value }),
        }
    }

    /// The parameter with its value, if it is one.
    pub(super) fn parameter(&self) -> Option<(String, f64)> {
        match self {
            Self::Parameter { name, value } => Some((name.clone(), *value)),
            Self::Heat { .. } => None,
        }
    }
}
