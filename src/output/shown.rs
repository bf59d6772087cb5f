//! What a picture shows of the light.

use crate::elements::coating::Coating;

/// The quantity that a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Shown {
    /// What leaves surfaces, as the eye sees it.
    #[default]
    Radiosity,
    /// What arrives at surfaces, as an illuminance meter shows it where the unit is lx.
    Irradiance,
}

impl Shown {
    /// The quantity (unit of exitance, ≥ 0) of an element under the irradiance `irradiance`; negative values of
    /// polynomials are cut off at zero.
    pub fn of(self, coating: &Coating, element: usize, irradiance: f64) -> f64 {
        let value = match self {
            Self::Radiosity => coating.radiosity(element, irradiance),
            Self::Irradiance => irradiance,
        };
        value.max(0.0)
    }

    /// Its name in the unit `unit`: irradiance is illuminance in lux.
    pub fn name(self, unit: &str) -> &'static str {
        match self {
            Self::Radiosity => "radiosity",
            Self::Irradiance if matches!(unit, "lx" | "lux" | "klx" | "lm/m²" | "lm/m^2" | "lm m⁻²") => {
                "illuminance"
            }
            Self::Irradiance => "irradiance",
        }
    }
}
