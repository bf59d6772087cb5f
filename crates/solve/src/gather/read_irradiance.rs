//! Irradiance as it was gathered.

use serde::{Deserialize, Serialize};

/// Irradiance at a point, or its mean over a patch.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadIrradiance {
    /// Irradiance per band (W m⁻²).
    pub irradiance: Vec<f64>,
    /// Its error, as far as it is known.
    pub uncertainty: Uncertainty,
}

/// The error of an irradiance as far as its reading knows it, by default nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Uncertainty {
    /// Standard deviation of what was gathered by rays; None otherwise.
    pub deviation: Option<Deviation>,
    /// About the error that the polynomials of elements near by leave, root mean square over the bands (W m⁻²); 0 where
    /// none was looked for.
    pub doubt: f64,
}

/// Standard deviation of an irradiance by rays.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Deviation {
    /// Over the irradiance, root mean square over the bands.
    pub relative: f64,
    /// Root mean square over the bands (W m⁻²).
    pub absolute: f64,
    /// Whether a band has less than 2 % of the scene's mean radiosity, to which it is relative, or the point lies in a
    /// gap or in shadow, or a cell has less than the usual irradiance, where it is as small as asked for relative to
    /// the light of the scene.
    pub is_dark: bool,
}

impl ReadIrradiance {
    /// The irradiance with `other` light (W m⁻² per band), as well known as the rest.
    pub fn with(mut self, other: &[f64]) -> Self {
        self.irradiance.iter_mut().zip(other).for_each(|(sum, other)| *sum += other);
        self
    }
}

impl From<Vec<f64>> for ReadIrradiance {
    fn from(irradiance: Vec<f64>) -> Self {
        Self { irradiance, uncertainty: Uncertainty::default() }
    }
}
