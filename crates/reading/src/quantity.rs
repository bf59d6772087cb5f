//! Quantities of light that a picture shows.

use radiosity_elements::coating::Coating;
use serde::Deserialize;

/// The quantity that a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Exitance of surfaces, as the eye sees it.
    #[default]
    Radiosity,
    /// Irradiance of surfaces, as an illuminance meter shows it where the unit is lx.
    Irradiance,
}

/// The light at a place of an element.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlaceLight {
    /// Index of the element.
    pub element: usize,
    /// Parameters of its surface.
    pub parameters: [f64; 2],
    /// Irradiance (unit of exitance).
    pub irradiance: f64,
    /// Irradiance of the other side, where the element lets light through (unit of exitance).
    pub behind: f64,
    /// Radiance of its own light towards the eye, over that of a diffuse emitter.
    pub directed: f64,
}

impl Quantity {
    /// The quantity (unit of exitance, ≥ 0) at a place; negative values of polynomials are cut off at zero.
    pub(crate) fn of(self, coating: &Coating, light: &PlaceLight) -> f64 {
        let PlaceLight { element, parameters, irradiance, behind, directed } = *light;
        let value = match self {
            Self::Radiosity => {
                let radiosity = coating.radiosity(element, parameters, irradiance, behind);
                radiosity + (directed - 1.0) * coating.exitance_at(element, parameters)
            }
            Self::Irradiance => irradiance,
        };
        value.max(0.0)
    }

    /// Its name in the unit `unit`: irradiance is illuminance in lux.
    pub fn name(self, unit: &str) -> &'static str {
        match self {
            Self::Radiosity => "radiosity",
            Self::Irradiance if matches!(unit, "klx") || is_lux(unit) => "illuminance",
            Self::Irradiance => "irradiance",
        }
    }
}

/// Whether a unit of exitance is the lux.
fn is_lux(unit: &str) -> bool {
    matches!(unit, "lx" | "lux" | "lm/m²" | "lm/m^2" | "lm m⁻²")
}

/// The unit of power where exitance is in `unit` and lengths are metres: lm for lx, W for W/m², else their
/// product.
pub fn power_unit(unit: &str) -> String {
    match unit {
        _ if is_lux(unit) => "lm".to_owned(),
        "W/m²" | "W/m^2" | "W m⁻²" => "W".to_owned(),
        _ => format!("{unit} · m²"),
    }
}

/// The name of the band that is shown, or how several bands become one; none where there is only one.
pub fn band_name(bands: &[String], shown: Option<usize>) -> Option<String> {
    (bands.len() > 1).then(|| shown.map_or_else(|| "mean of bands".to_owned(), |band| bands[band].clone()))
}

/// The value that is shown: that of the band `shown`, or the mean of the values of all bands.
pub fn of_bands(values: &[f64], shown: Option<usize>) -> f64 {
    shown.map_or_else(|| values.iter().sum::<f64>() / values.len() as f64, |band| values[band])
}
