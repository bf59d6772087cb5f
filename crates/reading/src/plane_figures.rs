//! The figures of a plane of sensors, for the report and the summary.

use radiosity_scene::SensorPlane;
use radiosity_visibility::Surroundings;
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
    /// Number of the sensors that the figures are of.
    pub points: usize,
    /// Number of sensors outside of the room or within solids ([`is_in_room`]), which the figures leave out.
    pub left_out: usize,
    /// Number of sensors among `points` that get no light.
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
    /// The figures of a plane's `readings` in `bands`, with the `errors` that are told of them.
    pub fn of(plane: &SensorPlane, bands: &[String], readings: &[ProbeReading], errors: &[f64]) -> Self {
        let is_in_room = is_in_room(readings);
        let inside = in_room(readings, &is_in_room);
        let figures =
            |band: usize| Uniformity::of(inside.iter().map(move |reading| reading.irradiance[band]));
        let named = |(k, band): (usize, &String)| NamedFigures { band: band.clone(), figures: figures(k) };
        let figures = match bands.len() {
            1 => BandFigures::One(figures(0)),
            _ => BandFigures::Several { bands: bands.iter().enumerate().map(named).collect() },
        };
        Self {
            name: plane.name().to_owned(),
            points: inside.len(),
            left_out: readings.len() - inside.len(),
            dark: dark(&inside),
            error: root_mean_square(&in_room(errors, &is_in_room)),
            figures,
        }
    }

    /// A warning where sensors get no light, which a plane that goes through furniture has.
    pub fn warning(&self) -> Option<Warning> {
        let message = || {
            format!(
                "{} of the {} sensors of plane {:?} get no light and count in its figures: move the plane, or read several \
                 planes around what stands in it",
                self.dark, self.points, self.name
            )
        };
        (self.dark > 0).then(|| Warning::general("dark-sensors", message()))
    }

    /// A line for each band, with values in `unit`.
    pub fn lines(&self, unit: &str) -> Vec<String> {
        let Self { name, points, figures, .. } = self;
        let line = |named: String, figures: &Uniformity| {
            let text = figures.text(unit);
            format!("plane {named}: {points} points, {text}{}", self.left_out_text())
        };
        match figures {
            BandFigures::One(figures) => vec![line(name.clone(), figures)],
            BandFigures::Several { bands } => {
                bands.iter().map(|own| line(format!("{name}, band {}", own.band), &own.figures)).collect()
            }
        }
    }

    fn left_out_text(&self) -> String {
        match self.left_out {
            0 => String::new(),
            count => format!("; without {count} outside of the room or in solids"),
        }
    }
}

/// Which of some readings count in their figures: those that lie in the room, and all where none does.
pub fn is_in_room(readings: &[ProbeReading]) -> Vec<bool> {
    let inside: Vec<bool> = is_outside(readings, 0.0).into_iter().map(|is_outside| !is_outside).collect();
    if inside.contains(&true) { inside } else { vec![true; readings.len()] }
}

/// Tells which of some readings lie outside of the room or in a solid: they get no light, and meet no front of a
/// surface, or backs in at least as many directions. Backs alone do not tell: behind a panel of one side a room is
/// lit. Readings are dark beside the brightest of them, or beside `light` (W m⁻²) where that is more.
fn is_outside(readings: &[ProbeReading], light: f64) -> Vec<bool> {
    let is_dark = is_dark(readings.iter(), light);
    let is_behind = |own: &Surroundings| own.backs >= own.fronts;
    readings.iter().map(|reading| is_dark(reading) && is_behind(&reading.surroundings)).collect()
}

/// A warning of points outside of the room or in solids, of a scene with so much light (W m⁻²): all may be there.
pub(crate) fn outside_points(readings: &[ProbeReading], light: f64) -> Option<Warning> {
    let outside = is_outside(readings, light).into_iter().filter(|is_outside| *is_outside).count();
    let message =
        format!("{outside} of the {} points lie outside of the room or in solids: move them", readings.len());
    (outside > 0).then(|| Warning::general("outside-points", message))
}

/// The items of the sensors that count ([`is_in_room`]).
pub fn in_room<'a, T>(items: &'a [T], is_in_room: &[bool]) -> Vec<&'a T> {
    items.iter().zip(is_in_room).filter(|(_, inside)| **inside).map(|(item, _)| item).collect()
}

fn root_mean_square(errors: &[&f64]) -> Option<f64> {
    let squares: f64 = errors.iter().map(|error| **error * **error).sum();
    (!errors.is_empty()).then(|| (squares / errors.len() as f64).sqrt())
}

/// Number of readings without light in any band.
fn dark(readings: &[&ProbeReading]) -> usize {
    let is_dark = is_dark(readings.iter().copied(), 0.0);
    readings.iter().filter(|reading| is_dark(reading)).count()
}

/// Whether a reading has no light in any band, beside the brightest of `readings` and beside `light` (W m⁻²).
fn is_dark<'a>(
    readings: impl Iterator<Item = &'a ProbeReading>,
    light: f64,
) -> impl Fn(&ProbeReading) -> bool {
    let greatest = |reading: &ProbeReading| reading.irradiance.iter().copied().fold(0.0, f64::max);
    let most = readings.map(greatest).fold(light, f64::max);
    move |reading| greatest(reading) <= DARK * most
}
