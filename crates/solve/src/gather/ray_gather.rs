//! Light at a point by rays, with an error that is known.
//!
//! Rays of a receiver (`super::receiver_rays`) find the light where they end (`super::met_light`). The estimate
//! has no bias beside that of the polynomials of reflected light there; emitters may be near or far, curved, partly
//! hidden. Rays are doubled until the standard deviation s of their mean (`super::ray_estimate`) is below the accuracy
//! asked for, or many times the usual number are sent.
//!
//! *Trusted*, readings of all light at y that may be far from what polynomials say, y on a large element beside x
//! or near an emitter, go on from there (`super::trusted_light`), and take polynomials of all light nowhere.
//!
//! Over a patch the light of flat emitters and balls that are far is found apart, by rays to these
//! (`super::known_lamps`); of many patches direct light at y is that of cells (`super::lit_cells`).
//!
//! Gathered twice, the irradiance of y is itself estimated so, by one ray of either kind.
//!
//! *Walked*, what is reflected at y is added by a walk from there (`super::walked_light`): nothing of the polynomials
//! is left, and the mean has no bias but that of stopping where eight sequences agree. Walks are doubled while they
//! come to few surfaces; what is read with too few tells a deviation that is too large.

use std::sync::Arc;
use std::time::Instant;

use radiosity_light::direct::DirectLight;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_light::tolerances::DARK;
use radiosity_visibility::Visibility;
use radiosity_work::Pace;

use crate::gather::known_lamps::FarLamps;
use crate::gather::met_light::{Ending, Held, MetLight};
use crate::gather::ray_count::{
    FIRST, FIRST_OF_CELLS, FIRST_OF_MANY, FIRST_TO_FAR, FIRST_TOGETHER, PATIENCE, PATIENCE_OF_MANY,
    most_rays, most_walks, usual_rays,
};
use crate::gather::ray_estimate::{BandLight, Batches, Beside, Estimate, Sequences};
use crate::gather::read_irradiance::ReadIrradiance;
use crate::gather::receiver::Receiver;
use crate::gather::receiver_rays::{Onward, ReceiverRays};
use crate::gather::trusted_light::WalkEnds;
use crate::solution::Solution;

/// [`FIRST`] of walks. Chosen: a few of them bring much of the light, and without any the error looks small. As many
/// are sent at once at first, in case that they are long.
const FIRST_WALKS: u64 = 256;
const FEWEST_WALKS: u64 = 16;

/// Factor on the standard deviation of so few sequences where it decides that rays are enough: those whose
/// sequences agree by chance stop first. Measured in a classroom.
const CAUTION: f64 = 1.25;

/// As [`CAUTION`], of the cells of a grid, of which the error of all counts. Measured in an office of 430 surfaces,
/// 2 × 2 cells each, beside walks, with [`FIRST_OF_CELLS`]: with 1.25 and 32 its grid erred by .63 % (L2) in 11.2 s,
/// with these by .76 % in 7.4 s, and 99.5 % of the cells by less than three times what is told.
const CAUTION_OF_CELLS: f64 = 1.0;

/// Fewest rays that are sent at once for a cell, or for a place of a picture, over those that were sent. Chosen. To
/// points that are read as many again are sent: where the error is looked at more often, more of those stop whose
/// sequences agree by chance. Measured on sixty random rooms: the largest error of a room was .88 % with steps of a
/// quarter, and is .78 %. Pictures average: one of a shop took 4.2 million rays and erred by .21 % (L2) with as many
/// again, and takes 3.5 and errs by .24 %.
const FEW_MORE: f64 = 0.25;

/// Light that the surfaces reflect which rays meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// The polynomials of the solution.
    Polynomials,
    /// These where they are trusted, elsewhere rays that go on until they are.
    Trusted,
    /// Gathered in its turn by one ray of either kind.
    Gathered,
    /// By rays that go on until they end.
    Walked,
}

impl Beyond {
    /// How it is found, with polynomials where it is `held`.
    fn onward(self, held: Held) -> Onward {
        match self {
            Self::Polynomials => Onward::Ends(Ending::Polynomials(held)),
            Self::Trusted => Onward::Walks(WalkEnds::Trusted { by_cells: held.cells }),
            Self::Gathered => Onward::Ends(Ending::Gathered),
            Self::Walked => Onward::Walks(WalkEnds::Never),
        }
    }
}

/// A solution whose light is gathered by rays.
#[derive(Debug)]
pub struct RayGather<'a> {
    light: Arc<MetLight<'a>>,
    /// Direct light of points by cells; None where rays find it.
    direct: Option<DirectLight<'a>>,
    eps: f64,
    /// Irradiance per band below which errors are to be small relative to this (W m⁻²).
    dark: Vec<f64>,
    beyond: Beyond,
    /// The pace of readings that are to end by a deadline.
    pace: Option<&'a Pace>,
}

/// Wishes for a reading.
struct Wanted<'s> {
    sequences: Sequences,
    /// Cosine-distributed rays of each sequence that are sent at first.
    first: u64,
    /// Factor on the deviation where it decides that rays are enough.
    caution: f64,
    /// Most rays over their expected number.
    patience: f64,
    /// Fewest rays that are sent at once later, over those that were sent.
    least: f64,
    /// Irradiance per band below which errors are to be small relative to this (W m⁻²).
    dark: &'s [f64],
}

/// Numbers of cosine-distributed rays of each sequence.
#[derive(Clone, Copy)]
struct RayCounts {
    /// Sent at once at first.
    first: u64,
    /// Least before the error is looked at.
    least: u64,
    /// Most of all sequences.
    most: u64,
}

impl<'a> RayGather<'a> {
    /// The light of `solution`, gathered to about the relative accuracy `eps`, with the light of what rays meet
    /// taken from `beyond`; where the number of reflections is limited, from the polynomials.
    pub fn new(solution: &'a Solution, visibility: &'a Visibility, eps: f64, beyond: Beyond) -> Self {
        Self::of(Arc::new(MetLight::of(solution, visibility)), eps, beyond)
    }

    /// [`RayGather::new`] of light that others may share.
    pub(super) fn of(light: Arc<MetLight<'a>>, eps: f64, beyond: Beyond) -> Self {
        let beyond = if light.solution.is_truncated() { Beyond::Polynomials } else { beyond };
        // What is darker than most would take most of the walks, and counts little in the L2 mean.
        let dark = match beyond {
            Beyond::Walked => light.usual.clone(),
            _ => light.scale.iter().map(|scale| DARK * scale).collect(),
        };
        Self { light, direct: None, eps, dark, beyond, pace: None }
    }

    /// As made, but errors are to be small relative to the irradiance `dark` (W m⁻² per band) where less arrives.
    pub(super) fn with_dark(self, dark: Vec<f64>) -> Self {
        Self { dark, ..self }
    }

    /// As made, but errors are to be small relative to the usual irradiance where less arrives.
    pub(super) fn beside_usual(self) -> Self {
        let usual = self.light.usual.clone();
        self.with_dark(usual)
    }

    /// As made, but the direct light of points is taken from `direct`.
    pub(super) fn beside(self, direct: DirectLight<'a>) -> Self {
        Self { direct: Some(direct), ..self }
    }

    /// As made, but readings end at this pace: with the rays that were sent until then, and their error.
    pub(super) fn paced(self, pace: &'a Pace) -> Self {
        Self { pace: Some(pace), ..self }
    }

    /// Direct light (W m⁻² per band) of a point by cells; None where rays find it.
    pub(super) fn direct_by_cells(&self, receiver: &ReceiverPoint) -> Option<Vec<f64>> {
        let direct = self.direct.as_ref()?;
        Some(direct.irradiance(receiver, &direct.around(&receiver.site())))
    }

    /// All light of a receiver, by rays alone. It depends on nothing but the receiver.
    pub fn read(&self, origin: &Receiver) -> ReadIrradiance {
        let rays = ReceiverRays::all(&self.light, origin, self.beyond.onward(Held::READ));
        self.gathered(&rays, &self.wanted_of(origin), &vec![0.0; self.dark.len()])
    }

    /// All light of a receiver that is one of so many, by rays alone, accurate relative to the usual irradiance where
    /// less arrives, but by walks. It depends on nothing but the receiver and their number.
    ///
    /// Polynomials are taken where they are trusted alone: patches in the dark, of which there are many, see mostly
    /// what is near.
    pub fn read_one_of(&self, origin: &Receiver, count: usize) -> ReadIrradiance {
        let are_worth = self.light.lit_cells.are_worth(count as f64 * usual_rays(self.eps));
        let held = if are_worth { Held::READ.beside_cells() } else { Held::READ };
        let is_beside = self.beyond == Beyond::Polynomials && !self.light.solution.is_truncated();
        let beyond = if is_beside { Beyond::Trusted } else { self.beyond };
        let rays = ReceiverRays::all(&self.light, origin, beyond.onward(held));
        let is_walked = self.beyond == Beyond::Walked;
        let larger = |(usual, dark): (&f64, &f64)| if is_walked { *dark } else { dark.max(*usual) };
        let dark: Vec<f64> = self.light.usual.iter().zip(&self.dark).map(larger).collect();
        let wanted = Wanted {
            sequences: Sequences::Independent,
            first: FIRST_OF_CELLS,
            caution: CAUTION_OF_CELLS,
            patience: PATIENCE_OF_MANY,
            least: FEW_MORE,
            dark: &dark,
        };
        let mut read = self.gathered(&rays, &wanted, &vec![0.0; dark.len()]);
        if !is_walked {
            let is_dim = read.irradiance.iter().zip(&dark).any(|(light, dark)| light < dark);
            read.uncertainty.deviation.iter_mut().for_each(|deviation| deviation.is_dark |= is_dim);
        }
        read
    }

    /// The reflected light of a receiver alone, accurate relative to this and the light `other` (W m⁻² per band).
    pub(super) fn reflected_alone(&self, origin: &Receiver, other: &[f64]) -> ReadIrradiance {
        let rays = ReceiverRays::reflected(&self.light, origin, self.beyond.onward(Held::READ));
        self.gathered(&rays, &self.wanted_of(origin), other)
    }

    /// The reflected light of a point alone, one of many, in a narrow gap between the surfaces `own`, accurate relative
    /// to this and the light `other` (W m⁻² per band).
    pub(super) fn reflected_in_gap(
        &self,
        receiver: &ReceiverPoint,
        own: [usize; 2],
        other: &[f64],
    ) -> ReadIrradiance {
        let origin = Receiver::Point(*receiver);
        let rays = ReceiverRays::reflected(&self.light, &origin, Onward::Walks(WalkEnds::OutOfGap(own)));
        self.gathered(&rays, &self.wanted(FIRST_OF_MANY), other)
    }

    /// The reflected light of a point alone, one of many, accurate relative to this and the light `other` (W m⁻²
    /// per band); from polynomials where these are trusted.
    pub fn reflected(&self, receiver: &ReceiverPoint, other: &[f64]) -> ReadIrradiance {
        let beyond = if self.beyond == Beyond::Trusted { Beyond::Polynomials } else { self.beyond };
        let origin = Receiver::Point(*receiver);
        let rays = ReceiverRays::reflected(&self.light, &origin, beyond.onward(Held::BEHIND_PIXELS));
        match beyond {
            Beyond::Polynomials => {
                let sequences = Sequences::OneAfterTheOther;
                let wanted = Wanted { sequences, least: FEW_MORE, ..self.wanted(FIRST_TOGETHER) };
                self.gathered(&rays, &wanted, other)
            }
            _ => self.gathered(&rays, &self.wanted(FIRST_OF_MANY), other),
        }
    }

    /// As [`RayGather::reflected`], but polynomials are left where they are not trusted.
    pub(super) fn reflected_onward(&self, receiver: &ReceiverPoint, other: &[f64]) -> ReadIrradiance {
        let origin = Receiver::Point(*receiver);
        let rays = ReceiverRays::reflected(&self.light, &origin, self.beyond.onward(Held::READ));
        self.gathered(&rays, &self.wanted(FIRST_OF_MANY), other)
    }

    /// Numbers of rays, as they are `wanted`.
    fn counts(&self, wanted: &Wanted) -> RayCounts {
        let Wanted { first, patience, .. } = *wanted;
        match self.beyond {
            Beyond::Walked => {
                RayCounts { first: FEWEST_WALKS, least: FIRST_WALKS, most: most_walks(self.eps) }
            }
            _ => RayCounts { first, least: first, most: most_rays(self.eps, patience) },
        }
    }

    /// Wishes for one of many readings, of which so many rays are sent at first.
    fn wanted(&self, first: u64) -> Wanted<'_> {
        Wanted {
            sequences: Sequences::Independent,
            first,
            caution: CAUTION,
            patience: PATIENCE_OF_MANY,
            least: 1.0,
            dark: &self.dark,
        }
    }

    /// Wishes for the reading of a receiver; patches are many.
    fn wanted_of(&self, origin: &Receiver) -> Wanted<'_> {
        match origin {
            Receiver::Point(_) => Wanted { patience: PATIENCE, ..self.wanted(FIRST) },
            Receiver::Patch(..) => self.wanted(FIRST),
        }
    }

    /// Light by these rays, as it is `wanted`; `other` light (W m⁻² per band) arrives too. Further rays are sent of the
    /// kind that errs more: around, or to far emitters.
    fn gathered(&self, rays: &ReceiverRays, wanted: &Wanted, other: &[f64]) -> ReadIrradiance {
        let Wanted { sequences, caution, least: least_more, dark, .. } = *wanted;
        let bands = dark.len();
        let beside = Beside { scale: &self.light.scale, dark, other };
        let RayCounts { first, least, most } = self.counts(wanted);
        let number = rays.number();
        let ends = self.pace.map(Pace::end_of_next);
        let (mut around, mut to_far) = (Batches::of(sequences, bands), Batches::of(sequences, 2 * bands));
        let send_around = |around: &mut Batches, count: u64| {
            around.send(number, count, |number, indices, scores| rays.add(number, indices, scores));
        };
        let send_far = |to_far: &mut Batches, far: &FarLamps, count: u64| {
            to_far.send(number, count, |number, indices, scores| rays.add_far(far, number, indices, scores));
        };
        send_around(&mut around, first);
        let far = rays.far();
        far.iter().for_each(|far| send_far(&mut to_far, far, FIRST_TO_FAR));
        loop {
            let reflected = around.light(&self.light.scale);
            let direct = far.map(|far| to_far.part_of(&far.whole));
            let all: Option<Vec<BandLight>> =
                direct.as_ref().map(|direct| reflected.iter().zip(direct).map(|(a, b)| a.and(b)).collect());
            let estimate = Estimate::of(all.as_ref().unwrap_or(&reflected), &beside, around.are_whole());
            let (is_first, missed) = (around.sent() < least, caution * estimate.missed / self.eps);
            if !is_first && missed <= 1.0 {
                return estimate.into();
            }
            if ends.is_some_and(|ends| Instant::now() >= ends) {
                self.pace.iter().for_each(|pace| pace.note_cut_short());
                return estimate.into();
            }
            let err_more = |direct: &Vec<BandLight>| sum(direct) > sum(&reflected);
            let more = |sent: u64| if is_first { sent } else { further(sent, missed, least_more) };
            let is_far = !is_first && direct.as_ref().is_some_and(err_more);
            match far {
                Some(far) if (is_far || around.are_last(most)) && !to_far.are_last(most) => {
                    let count = more(to_far.sent());
                    send_far(&mut to_far, far, count);
                }
                _ if !around.are_last(most) => {
                    let count = more(around.sent());
                    send_around(&mut around, count);
                }
                _ => return estimate.into(),
            }
        }
    }
}

/// Sum of the errors over the bands (W m⁻²).
fn sum(light: &[BandLight]) -> f64 {
    light.iter().map(|band| band.error).sum()
}

/// Further rays after so many whose error is `missed` times what is allowed: as far as it falls as in rooms, at most as
/// many again, and the part `least` of them at least. Two at least, so that readings end that are no numbers.
fn further(sent: u64, missed: f64, least: f64) -> u64 {
    let more = (missed.powf(4.0 / 3.0) - 1.0).clamp(least, 1.0);
    2 * ((0.5 * more * sent as f64).ceil() as u64).max(1)
}
