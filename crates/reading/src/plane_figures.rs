//! The figures of a plane of sensors, for the report and the summary.

use radiosity_scene::SensorPlane;
use serde::Serialize;

use super::probe::ProbeReading;
use super::uniformity::Uniformity;
use super::warning::Warning;

/// Part of the greatest irradiance of a plane below which there is no light: it is the rounding of gathered
/// light.
const DARK: f64 = 1e-9;

/// Figures of the readings of a plane's sensors.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlaneFigures {
    /// Name of the plane.
    pub name: String,
    /// Number of its sensors.
    pub points: usize,
    /// Number of sensors that get no light: those within a body, as a rule.
    pub dark: usize,
    /// Error that is told of the mean, in the unit of the readings, root mean square over the bands: that of
    /// their sensors, which it does not exceed. None where none is told.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// Figures by band.
    #[serde(flatten)]
    pub figures: BandFigures,
}

/// The figures of the only band as they are, of several bands by name.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum BandFigures {
    /// Figures of the only band.
    One(Uniformity),
    /// Figures of several bands.
    Several {
        /// The bands in the scene's order.
        bands: Vec<NamedFigures>,
    },
}

/// The figures of a band.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedFigures {
    /// Name of the band.
    pub band: String,
    /// Its figures.
    #[serde(flatten)]
    pub figures: Uniformity,
}

impl PlaneFigures {
    /// The figures of a plane's `readings` in `bands`.
    pub fn of(plane: &SensorPlane, bands: &[String], readings: &[ProbeReading]) -> Self {
        let figures =
            |band: usize| Uniformity::of(readings.iter().map(move |reading| reading.irradiance[band]));
        let named = |(k, band): (usize, &String)| NamedFigures { band: band.clone(), figures: figures(k) };
        let figures = match bands.len() {
            1 => BandFigures::One(figures(0)),
            _ => BandFigures::Several { bands: bands.iter().enumerate().map(named).collect() },
        };
        Self {
            name: plane.name().to_owned(),
            points: readings.len(),
            dark: dark(readings),
            error: None,
            figures,
        }
    }

    /// The figures with the error that follows from those of the sensors.
    #[must_use]
    pub fn erring(self, errors: &[f64]) -> Self {
        let squares: f64 = errors.iter().map(|error| error * error).sum();
        Self { error: Some((squares / errors.len().max(1) as f64).sqrt()), ..self }
    }

    /// A warning where sensors get no light, which a plane that goes through furniture has.
    pub fn warning(&self) -> Option<Warning> {
        let message = || {
            format!(
                "{} of the {} sensors of plane {:?} get no light, as sensors within a body do, and count in its figures: move \
                 the plane, or read several planes around what stands in it",
                self.dark, self.points, self.name
            )
        };
        (self.dark > 0).then(|| Warning::general("dark-sensors", message()))
    }

    /// A line for each band, with values in `unit`.
    pub fn lines(&self, unit: &str) -> Vec<String> {
        let Self { name, points, figures, .. } = self;
        match figures {
            BandFigures::One(figures) => {
                vec![format!("plane {name}: {points} points, {}", figures.text(unit))]
            }
            BandFigures::Several { bands } => {
                let line = |NamedFigures { band, figures }: &NamedFigures| {
                    format!("plane {name}, band {band}: {points} points, {}", figures.text(unit))
                };
                bands.iter().map(line).collect()
            }
        }
    }
}

/// Number of readings without light in any band.
fn dark(readings: &[ProbeReading]) -> usize {
    let greatest = |reading: &ProbeReading| reading.irradiance.iter().copied().fold(0.0, f64::max);
    let most = readings.iter().map(greatest).fold(0.0, f64::max);
    readings.iter().filter(|reading| greatest(reading) <= DARK * most).count()
}
