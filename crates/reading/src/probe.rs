//! Irradiance at single points, and radiosity where they lie on a surface.

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_audit::Spot;
use radiosity_geom::DVec3;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_scene::{Scene, SensorPlane};
use radiosity_solve::gather::lune::Lune;
use radiosity_solve::gather::read_irradiance::{ReadIrradiance, Uncertainty};
use radiosity_solve::gather::standpoint::Standpoint;
use radiosity_solve::gather::surface_point::SurfacePoint;
use radiosity_solve::solution::SurfacePlace;
use radiosity_visibility::Surroundings;
use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};
use serde::{Deserialize, Serialize};

use crate::reader::{Reader, RecomputedLight};

/// Least cosine between a probe's normal and its surface's for which they count as equal where only
/// polynomials are known (0.8°): normals of probes are typed with few digits.
const SAME_NORMAL: f64 = 0.9999;
/// Least cosine for which they count as equal where light is gathered along any normal: some hundred
/// roundings.
const EQUAL_NORMAL: f64 = 1.0 - 1e-14;

/// A point with the direction it receives along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// The point, in the coordinates that the scene was given in.
    pub position: DVec3,
    /// Unit normal.
    pub normal: DVec3,
}

impl Probe {
    /// A probe that receives along a direction of any length; None for one of length 0, or not finite.
    pub fn along(position: DVec3, direction: DVec3) -> Option<Self> {
        // Scaled by the largest component first: squares of very long or short directions leave the range of
        // numbers.
        let largest = direction.abs().max_element();
        let is_some = direction.is_finite() && largest > 0.0;
        is_some.then(|| Self { position, normal: (direction / largest).normalize() })
    }

    /// The spot that a referee reads in its place.
    pub fn spot(&self, scene: &Scene) -> Spot {
        Spot::Point { position: self.position - scene.middle, normal: self.normal }
    }

    /// The sensors of a plane, in order.
    pub fn of_plane(plane: &SensorPlane) -> impl Iterator<Item = Self> {
        let normal = plane.normal();
        plane.sensors().map(move |position| Self { position, normal })
    }
}

/// The result of a probe.
#[derive(Clone, Debug)]
pub struct ProbeReading {
    /// The probe itself.
    pub probe: Probe,
    /// Irradiance per band (W m⁻²).
    pub irradiance: Vec<f64>,
    /// Its error, as far as it is known.
    pub uncertainty: Uncertainty,
    /// The surface the probe lies on, if any.
    pub on: Option<OnSurface>,
    /// Surfaces that are met first about the probe.
    pub surroundings: Surroundings,
}

/// The surface under a probe.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct OnSurface {
    /// Index of the surface.
    pub surface: usize,
    /// Its parameters there, in [−1, 1]².
    pub parameters: [f64; 2],
    /// Radiosity per band (W m⁻²), from the irradiance along the surface's own normal.
    pub radiosity: Vec<f64>,
}

/// Why a probe cannot be read: polynomials exist on surfaces only, for their own normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error, Serialize, Deserialize)]
pub enum ProbeFault {
    /// The probe lies on no surface.
    #[error("the point lies on no surface that its normal leaves")]
    OffSurface,
    /// The probe's normal differs from its surface's.
    #[error("the normal is not that of the surface under the point")]
    Tilted,
}

/// Probes that one thread reads after each other. Chosen: they take up to some milliseconds each.
const TOGETHER: usize = 4;

/// Reads every probe; `middle` was subtracted from the scene's coordinates
/// ([`Scene::middle`](radiosity_scene::Scene::middle)).
///
/// # Errors
/// The index of the first probe that polynomials cannot answer, unless all light is gathered.
pub fn probe(
    reader: &Reader,
    probes: &[Probe],
    middle: DVec3,
    work: &Work<'_>,
) -> Result<Vec<ProbeReading>, (usize, ProbeFault)> {
    let found = work.during(Stage::Points, || probe_each(reader, probes, middle, work));
    found.into_iter().enumerate().map(|(number, found)| found.map_err(|fault| (number, fault))).collect()
}

/// Reads every probe as [`probe`] does, with the fault of each that polynomials cannot answer.
pub(crate) fn probe_each(
    reader: &Reader,
    probes: &[Probe],
    middle: DVec3,
    work: &Work<'_>,
) -> Vec<Result<ProbeReading, ProbeFault>> {
    let done = AtomicUsize::new(0);
    let found = work.ranks.map_even(PartName::Points, probes.len(), TOGETHER, |number| {
        let found = read(reader, &probes[number], middle);
        reader.note_read();
        work.report_done(Stage::Points, done.fetch_add(1, Ordering::Relaxed) + 1, probes.len());
        found
    });
    let reading = |(probe, found): (&Probe, Result<ProbeValues, ProbeFault>)| {
        let ProbeValues { irradiance, uncertainty, on, surroundings } = found?;
        Ok(ProbeReading { probe: *probe, irradiance, uncertainty, on, surroundings })
    };
    probes.iter().zip(found).map(reading).collect()
}

/// The values read at a probe, which ranks send each other.
#[derive(Serialize, Deserialize)]
struct ProbeValues {
    irradiance: Vec<f64>,
    uncertainty: Uncertainty,
    on: Option<OnSurface>,
    surroundings: Surroundings,
}

fn read(reader: &Reader, probe: &Probe, middle: DVec3) -> Result<ProbeValues, ProbeFault> {
    let (position, normal) = (probe.position - middle, probe.normal);
    let elements = reader.solution().elements();
    let standpoint = Standpoint::find(elements, reader.visibility(), position, normal);
    let along_surface =
        |point: &SurfacePoint| reader.irradiance(point.element, &place(reader, point), point.normal);
    let (value, on) = match standpoint.on() {
        None => {
            let receiver = standpoint.receiver_point(normal);
            (reader.gathered(&receiver).ok_or(ProbeFault::OffSurface)?, None)
        }
        Some(point) if reader.gathers() && point.normal.dot(normal) < EQUAL_NORMAL => {
            let on = on(reader, point, &along_surface(point).irradiance);
            let receiver = point.receiver_point(normal);
            let above = reader.gathered(&receiver).ok_or(ProbeFault::Tilted)?;
            let below =
                Lune::of(&receiver, elements).map(|lune| lune.light(reader.solution(), &on.radiosity));
            (above.with(&below.unwrap_or_default()), Some(on))
        }
        Some(point) if point.normal.dot(normal) < SAME_NORMAL => return Err(ProbeFault::Tilted),
        Some(point) => {
            let value = along_surface(point);
            let on = on(reader, point, &value.irradiance);
            (value, Some(on))
        }
    };
    let ReadIrradiance { irradiance, uncertainty } = value;
    let surroundings = surroundings(reader, &standpoint.receiver_point(normal));
    Ok(ProbeValues { irradiance, uncertainty, on, surroundings })
}

fn surroundings(reader: &Reader, receiver: &ReceiverPoint) -> Surroundings {
    let ground = receiver.ground.unwrap_or(receiver.normal);
    reader.visibility().surroundings(receiver.position, receiver.surface.map(|surface| (surface, ground)))
}

/// Where a surface point is read: polynomials have a value at the foot itself, recomputed light near it.
fn place(reader: &Reader, point: &SurfacePoint) -> SurfacePlace {
    if !matches!(reader.light(), RecomputedLight::Basis) {
        return point.place;
    }
    let SurfacePlace { surface, .. } = point.place;
    let position = reader.solution().elements().shape(surface).jet(point.foot[0], point.foot[1]).position;
    SurfacePlace { surface, parameters: point.foot, position }
}

fn on(reader: &Reader, point: &SurfacePoint, irradiance: &[f64]) -> OnSurface {
    let behind = reader.behind(point.element, &place(reader, point), point.normal);
    let bands = reader.solution().bands().iter().zip(irradiance).zip(behind);
    let radiosity = bands.map(|((band, irradiance), behind)| {
        band.coating.radiosity(point.element, point.place.parameters, *irradiance, behind)
    });
    OnSurface { surface: point.place.surface, parameters: point.foot, radiosity: radiosity.collect() }
}
