//! Readers: the sources of values at points and means over cells.

use radiosity_geom::DVec3;
use radiosity_light::direct::DirectLight;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_solve::gather::gather_method::{GatherMethod, Gathering};
use radiosity_solve::gather::read_irradiance::ReadIrradiance;
use radiosity_solve::solution::{Solution, SurfacePlace};
use radiosity_visibility::Visibility;
use radiosity_work::Pace;
use serde::Deserialize;

/// The source of irradiance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum ReadMode {
    /// The polynomials of the elements alone.
    Basis,
    /// Direct light and its shadows recomputed at every point, the rest from the polynomials.
    Direct,
    /// Direct light, and the light that all surfaces reflect, gathered anew at every point, with shadows.
    Gather,
    /// As gather, with the light of those surfaces gathered as well: slower, for the last digit.
    GatherTwice,
}

/// A solution with the light that is recomputed from it.
#[derive(Debug)]
pub struct Reader<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    light: RecomputedLight<'a>,
    pace: Option<&'a Pace>,
}

/// The light that a [`Reader`] recomputes.
#[derive(Debug)]
pub(super) enum RecomputedLight<'a> {
    /// Nothing.
    Basis,
    /// Direct light.
    Direct(DirectLight<'a>),
    /// All light.
    Gathered(Gathering<'a>),
}

impl<'a> Reader<'a> {
    /// Prepares to read `solution`; recomputed light has about the relative accuracy `eps`.
    pub fn new(solution: &'a Solution, visibility: &'a Visibility, read: ReadMode, eps: f64) -> Self {
        Self::by(GatherMethod::Auto, solution, visibility, read, eps)
    }

    /// As [`Reader::new`], with gathered light by cells, by rays or by walks.
    pub fn by(
        by: GatherMethod,
        solution: &'a Solution,
        visibility: &'a Visibility,
        read: ReadMode,
        eps: f64,
    ) -> Self {
        let twice = read == ReadMode::GatherTwice;
        let light = match read {
            ReadMode::Basis => RecomputedLight::Basis,
            ReadMode::Direct => {
                RecomputedLight::Direct(DirectLight::within(&solution.emitters(), visibility, eps))
            }
            ReadMode::Gather | ReadMode::GatherTwice => {
                RecomputedLight::Gathered(by.readings(solution, visibility, eps, twice))
            }
        };
        Self { solution, visibility, light, pace: None }
    }

    /// As made, but what rays gather ends at this pace, with the error that it then has.
    pub fn paced(self, pace: &'a Pace) -> Self {
        let light = match self.light {
            RecomputedLight::Gathered(light) => RecomputedLight::Gathered(light.paced(pace)),
            light => light,
        };
        Self { light, pace: Some(pace), ..self }
    }

    /// As made, but what rays gather is to be accurate relative to the usual irradiance where less arrives: what counts
    /// in the mean of all readings.
    pub(super) fn for_mean(self) -> Self {
        let light = match self.light {
            RecomputedLight::Gathered(light) => RecomputedLight::Gathered(light.for_mean()),
            light => light,
        };
        Self { light, ..self }
    }

    /// Tells the pace, if there is one, that so many `readings` are to come.
    pub(super) fn expect(&self, readings: impl Fn() -> usize) {
        self.pace.iter().for_each(|pace| pace.expect(readings()));
    }

    /// Notes that a point or a patch of a cell is read, for the pace.
    pub(super) fn note_read(&self) {
        self.pace.iter().for_each(|pace| pace.note_done());
    }

    /// The solution that is read.
    pub(super) fn solution(&self) -> &'a Solution {
        self.solution
    }

    /// The obstacles of the scene.
    pub(super) fn visibility(&self) -> &'a Visibility {
        self.visibility
    }

    /// Whether all light is gathered.
    pub(super) fn gathers(&self) -> bool {
        matches!(self.light, RecomputedLight::Gathered(_))
    }

    /// The light that is recomputed.
    pub(super) fn light(&self) -> &RecomputedLight<'a> {
        &self.light
    }

    /// The polynomials of irradiance (W m⁻²) per band at a place of an element.
    pub(super) fn polynomials(&self, element: usize, place: &SurfacePlace) -> Vec<f64> {
        let bands = 0..self.solution.bands().len();
        bands.map(|band| self.solution.irradiance(band, element, place)).collect()
    }

    /// The polynomials of the irradiance (W m⁻²) that was reflected at least once, per band.
    pub(super) fn indirect_polynomials(&self, element: usize, place: &SurfacePlace) -> Vec<f64> {
        let bands = 0..self.solution.bands().len();
        bands.map(|band| self.solution.indirect(band, element, place)).collect()
    }

    /// Irradiance per band at a place of an element with unit normal `normal`, on its front.
    pub fn irradiance(&self, element: usize, place: &SurfacePlace, normal: DVec3) -> ReadIrradiance {
        match &self.light {
            RecomputedLight::Basis => self.polynomials(element, place).into(),
            RecomputedLight::Direct(direct) => {
                let rest = self.indirect_polynomials(element, place);
                let lit = direct.at_beside(element, place.position, normal, &rest);
                lit.iter().zip(rest).map(|(d, s)| d + s).collect::<Vec<f64>>().into()
            }
            RecomputedLight::Gathered(light) => {
                light.read(&ReceiverPoint::on(place.surface, place.position, normal))
            }
        }
    }

    /// Irradiance per band (W m⁻²) on the other side of a place of an element that lets light through; 0
    /// elsewhere. `normal` is that of the element.
    pub(super) fn behind(&self, element: usize, place: &SurfacePlace, normal: DVec3) -> Vec<f64> {
        match self.solution.behind(element, place) {
            Some((behind, place)) => self.irradiance(behind, &place, -normal).irradiance,
            None => vec![0.0; self.solution.bands().len()],
        }
    }

    /// Irradiance per band at any point; None where light is not gathered.
    pub fn gathered(&self, receiver: &ReceiverPoint) -> Option<ReadIrradiance> {
        match &self.light {
            RecomputedLight::Basis | RecomputedLight::Direct(_) => None,
            RecomputedLight::Gathered(light) => Some(light.read(receiver)),
        }
    }
}
