//! The light of a picture, in two parts: direct light, which has edges, and the rest, which is smooth.

use radiosity_geom::DVec3;
use radiosity_light::direct::DirectLight;
use radiosity_light::occluders::Occluders;
use radiosity_light::penumbra::{EmitterFactor, Penumbra, RayEffort, VisibleEmitters};
use radiosity_light::tolerances::DARK;
use radiosity_solve::gather::gather_method::{GatherMethod, GatheredBy, Gathering};
use radiosity_solve::gather::read_irradiance::ReadIrradiance;
use radiosity_solve::gather::{DOUBTFUL, DOUBTFUL_PIXEL};
use radiosity_solve::solution::Solution;
use radiosity_visibility::Visibility;
use serde::{Deserialize, Serialize};

use crate::quantity::{PlaceLight, Quantity};
use crate::reader::ReadMode;

use super::eye::SeenPlace;

/// Pairs of an emitter and something that may stand before it, at most, for which direct light is computed
/// without rays. Chosen.
const FEW: usize = 2000;

/// Relative accuracy of recomputed light in pictures and textures: finer than the steps of eight bits, 1/255.
/// A finer one takes longer and shows in none.
pub(crate) const GATHERED_FOR_PICTURES: f64 = 3e-3;

/// Error of gathered light by rays, over the accuracy asked for: ten or so values are averaged where light is
/// interpolated. Measured in an office: with 2, 3.2 and 5 pictures erred by 0.32, 0.35 and 0.43 % (L2), and a node
/// took 1.7, 1.0 and 0.5 ms. Chosen.
pub(crate) const AVERAGED: f64 = 4.0;

/// Error of direct light in penumbrae, over the accuracy asked for. Chosen: the eye finds no steps there.
const IN_PENUMBRA: f64 = 2.0;

/// RayEffort of the search for direct light on the other side of an element that lets light through: there is
/// no frame to compare it with.
const BEHIND: RayEffort = RayEffort { error_factor: 1.0, sure: true };

/// Direct irradiance at a place.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct DirectIrradiance {
    /// Irradiance per band (W m⁻²).
    pub bands: Vec<f64>,
    /// Emitters that were seen, where rays looked for them.
    pub visible: Option<VisibleEmitters>,
    /// Standard deviation of the sum over the bands (W m⁻²).
    pub error: f64,
}

/// Light that was computed.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct ComputedLight {
    /// Irradiance per band (W m⁻²).
    pub bands: Vec<f64>,
    /// Standard deviation of the sum over the bands (W m⁻²).
    pub error: f64,
}

/// Direct light and the rest.
#[derive(Debug)]
pub(crate) struct PictureLight<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    read: ReadMode,
    /// Relative accuracy of what is computed.
    eps: f64,
    /// Mean irradiance of the scene, the sum over the bands (W m⁻²).
    mean: f64,
    shown: Quantity,
    /// Point that it is seen from, in a picture (scene length).
    eye: Option<DVec3>,
    direct: DirectSource<'a>,
    /// Where the rest is gathered; None where it is read from the polynomials.
    rest: Option<Gathering<'a>>,
    doubt: Doubt,
}

/// Light over the mean of all surfaces below which pixels are read anew where that is doubtful. Measured in the
/// Cornell box, 256² pixels: where none is, 333 are off by a fifth of themselves, in the dark before the feet of the
/// blocks. With .4 45 are, in 1.45 times the time; with .15 50, in 1.2 times; with .08 105, in 1.1 times.
const DIM: f64 = 0.15;

/// Doubt about the polynomials around a place from which on the rest of its light is read anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Doubt {
    /// Of pixels, which are many: in shadow alone.
    OfPixels,
    /// Of texels, which are seen from near and far.
    OfTexels,
}

impl Doubt {
    /// The doubt over the light of a place, of which about so much is there (W m⁻² per band), where so much is the
    /// mean of all surfaces (W m⁻², the sum over the bands); None where none counts.
    fn at(self, all: &[f64], mean: f64) -> Option<f64> {
        match self {
            Self::OfPixels => (all.iter().sum::<f64>() < DIM * mean).then_some(DOUBTFUL_PIXEL),
            Self::OfTexels => Some(DOUBTFUL),
        }
    }
}

#[derive(Debug)]
enum DirectSource<'a> {
    /// Direct light is in the polynomials.
    None,
    Exact(DirectLight<'a>),
    Rays(Penumbra<'a>),
}

impl<'a> PictureLight<'a> {
    /// The light of `solution`, as it is read to about the relative accuracy `eps`.
    pub(crate) fn new(solution: &'a Solution, visibility: &'a Visibility, read: ReadMode, eps: f64) -> Self {
        let twice = read == ReadMode::GatherTwice;
        let gathering =
            || GatherMethod::Auto.gathering(solution, visibility, eps, AVERAGED, f64::INFINITY, twice);
        let rest = Self::is_gathered(read).then(gathering);
        let emitters = solution.emitters();
        let direct = match read {
            ReadMode::Basis => DirectSource::None,
            _ if is_exact(solution, visibility) => {
                DirectSource::Exact(DirectLight::within(&emitters, visibility, eps))
            }
            _ => DirectSource::Rays(Penumbra::new(&emitters, visibility, IN_PENUMBRA * eps)),
        };
        let mean = solution.mean_arriving().iter().sum();
        let shown = Quantity::default();
        Self { solution, visibility, read, eps, mean, shown, eye: None, direct, rest, doubt: Doubt::OfPixels }
    }

    /// This light, as texels show it.
    pub(crate) fn of_texels(self) -> Self {
        Self { doubt: Doubt::OfTexels, ..self }
    }

    /// This light, of which a picture shows the quantity `shown`, as seen from the point `eye`.
    pub(crate) fn showing(self, shown: Quantity, eye: DVec3) -> Self {
        Self { shown, eye: Some(eye), ..self }
    }

    /// Whether the rest of light that is `read` so is gathered.
    pub(crate) fn is_gathered(read: ReadMode) -> bool {
        !matches!(read, ReadMode::Basis | ReadMode::Direct)
    }

    /// Whether the rest is gathered: then it is dear, and smooth across elements.
    pub(crate) fn gathers(&self) -> bool {
        self.rest.is_some()
    }

    /// Whether a place lies in a narrow gap, in which the rest is another one than around it.
    pub(crate) fn is_in_gap(&self, seen: &SeenPlace) -> bool {
        self.rest.as_ref().is_some_and(|rest| rest.is_in_gap(&seen.receiver_point()))
    }

    /// Whether rays gather the rest.
    pub(crate) fn gathers_by_rays(&self) -> bool {
        self.rest.as_ref().is_some_and(|rest| matches!(rest.by(), GatheredBy::Rays(_)))
    }

    /// About the seconds of one core in which cells gather the rest at so many places, with their tables.
    pub(crate) fn seconds_by_cells(&self, places: f64) -> f64 {
        let Self { solution, visibility, eps, .. } = *self;
        let twice = self.read == ReadMode::GatherTwice;
        GatherMethod::Cells.seconds(solution, visibility, eps, places, f64::INFINITY, twice)
    }

    /// Relative accuracy of what is computed.
    pub(crate) fn eps(&self) -> f64 {
        self.eps
    }

    /// Rays for direct light, where they find it: it takes longer then than a fit to what is known around.
    pub(crate) fn penumbra(&self) -> Option<&Penumbra<'a>> {
        match &self.direct {
            DirectSource::Rays(light) => Some(light),
            DirectSource::None | DirectSource::Exact(_) => None,
        }
    }

    /// Direct light at a place; `around` is what may stand between places about it and each emitter, where that
    /// is known.
    pub(crate) fn direct(
        &self,
        seen: &SeenPlace,
        around: Option<&Occluders>,
        effort: RayEffort,
    ) -> DirectIrradiance {
        let mut bands = vec![0.0; self.solution.bands().len()];
        let (mut visible, mut error) = (None, 0.0);
        match &self.direct {
            DirectSource::None => {}
            DirectSource::Exact(light) => {
                let rest = self.polynomials(seen);
                bands = light.at_beside(seen.element, seen.place.position, seen.normal, &rest);
            }
            DirectSource::Rays(light) => {
                let rest = self.polynomials(seen);
                let beside = rest.iter().sum::<f64>() / rest.len() as f64;
                let estimate = light.estimate(&seen.receiver_point(), around, beside, effort);
                bands = estimate.points;
                for EmitterFactor { element, value } in estimate.factors {
                    for (sum, band) in bands.iter_mut().zip(self.solution.bands()) {
                        *sum += value * band.coating.exitance[element];
                    }
                }
                visible = Some(estimate.visible);
                error = estimate.error * bands.len() as f64;
            }
        }
        DirectIrradiance { bands, visible, error }
    }

    /// The rest of the light beside the direct light `lit` (W m⁻² per band), with `error_factor` times the usual error.
    pub(crate) fn rest(&self, seen: &SeenPlace, lit: &[f64], error_factor: f64) -> ComputedLight {
        let Some(gathering) = &self.rest else {
            return ComputedLight { bands: self.polynomials(seen), error: 0.0 };
        };
        let all = self.all(seen, lit);
        let other = self.beside(&all, lit, error_factor);
        let point = seen.receiver_point();
        let ReadIrradiance { irradiance, uncertainty } =
            gathering.reflected_for_sure(&point, lit, &other, self.doubt.at(&all, self.mean));
        let all: f64 = irradiance.iter().chain(&other).sum();
        ComputedLight {
            bands: irradiance,
            error: uncertainty.deviation.map_or(0.0, |own| own.relative * all),
        }
    }

    /// Light (W m⁻² per band) beside which the rest of `all` light of a place is to be accurate: the direct light
    /// `lit`, and in the dark what makes all light E the mean √(E Ē) of this and that of the scene, as eyes and fits
    /// allow; so much more where `error_factor` times the error is allowed.
    fn beside(&self, all: &[f64], lit: &[f64], error_factor: f64) -> Vec<f64> {
        let size = all.iter().sum::<f64>().max(DARK * self.mean);
        let more = error_factor * (self.mean / size).sqrt().max(1.0) - 1.0;
        lit.iter().zip(all).map(|(lit, all)| lit + more * all).collect()
    }

    /// All light (W m⁻² per band) with the rest by polynomials beside the direct light `lit`.
    fn all(&self, seen: &SeenPlace, lit: &[f64]) -> Vec<f64> {
        self.polynomials(seen).iter().zip(lit).map(|(rest, lit)| rest + lit).collect()
    }

    /// Irradiance per band (W m⁻²) by the polynomials: all of it, or the part that was reflected at least
    /// once, cut off at 0.
    pub(crate) fn polynomials(&self, seen: &SeenPlace) -> Vec<f64> {
        let bands = 0..self.solution.bands().len();
        match self.direct {
            DirectSource::None => {
                bands.map(|band| self.solution.irradiance(band, seen.element, &seen.place)).collect()
            }
            _ => {
                let mut rest = vec![0.0; bands.len()];
                self.solution.indirect_bands(seen.element, &seen.place, &mut rest);
                rest.into_iter().map(|value| value.max(0.0)).collect()
            }
        }
    }

    /// The shown quantity per band (unit of exitance) under this irradiance.
    pub(crate) fn shown(&self, seen: &SeenPlace, irradiance: impl Iterator<Item = f64>) -> Vec<f64> {
        let bands = self.solution.bands().iter();
        let (directed, behind) = (self.directed(seen), self.behind(seen));
        let light = bands.zip(irradiance).zip(behind);
        let (element, parameters) = (seen.element, seen.place.parameters);
        light
            .map(|((band, irradiance), behind)| {
                let place_light = PlaceLight { element, parameters, irradiance, behind, directed };
                self.shown.of(&band.coating, &place_light)
            })
            .collect()
    }

    /// Irradiance per band (W m⁻²) on the other side of a place that lets light through: direct light, and
    /// polynomials for the rest; else 0.
    fn behind(&self, seen: &SeenPlace) -> Vec<f64> {
        let shows = self.shown == Quantity::Radiosity;
        let behind = if shows { self.solution.behind(seen.element, &seen.place) } else { None };
        let Some((element, place)) = behind else { return vec![0.0; self.solution.bands().len()] };
        let other_side = SeenPlace { element, place, normal: -seen.normal };
        let direct = self.direct(&other_side, None, BEHIND).bands;
        direct.iter().zip(self.polynomials(&other_side)).map(|(d, s)| d + s).collect()
    }

    /// Radiance of the own light of a place towards the eye, over that of a diffuse emitter.
    fn directed(&self, seen: &SeenPlace) -> f64 {
        self.eye.map_or(1.0, |eye| {
            let into = (eye - seen.place.position).normalize_or_zero();
            self.solution.emitters().radiances.relative(seen.place.surface, into)
        })
    }

    /// Light √(E max(E, Ē)) relative to which errors are judged at a place of all the light E, the sum over the bands,
    /// with the mean Ē of the scene (W m⁻²).
    pub(crate) fn judged_by(&self, all: f64) -> f64 {
        (all * all.max(self.mean)).sqrt()
    }

    /// The solution whose light it is.
    pub(crate) fn solution(&self) -> &'a Solution {
        self.solution
    }
}

/// Whether direct light has closed forms at little cost: flat emitters behind few things, all flat. So it is
/// without shadows too.
fn is_exact(solution: &Solution, visibility: &Visibility) -> bool {
    let (list, coatings) = (solution.elements().list(), solution.coatings());
    let emits = |element: &usize| coatings.iter().any(|coating| coating.exitance[*element] > 0.0);
    let emitters: Vec<usize> = (0..list.len()).filter(emits).collect();
    let standing: Vec<usize> =
        (0..solution.elements().surfaces()).filter(|surface| visibility.stands(*surface)).collect();
    !visibility.casts()
        || (emitters.iter().all(|emitter| list[*emitter].plane.is_some())
            && visibility.are_planar(&standing)
            && emitters.len() * standing.len() <= FEW)
}
