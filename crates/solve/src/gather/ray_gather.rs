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
//! Gathered twice, the irradiance of y is itself estimated so, by one ray of either kind.
//!
//! *Walked*, what is reflected at y is added by a walk from there (`super::walked_light`): nothing of the polynomials
//! is left, and the mean has no bias but that of stopping where eight sequences agree. Walks are doubled while they
//! come to few surfaces; what is read with too few tells a deviation that is too large.

use std::sync::Arc;

use radiosity_light::direct::DirectLight;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_light::tolerances::DARK;
use radiosity_visibility::Visibility;

use crate::gather::met_light::{Ending, Held, MetLight};
use crate::gather::ray_count::{FIRST, FIRST_OF_MANY, FIRST_TOGETHER, most_rays, most_walks};
use crate::gather::ray_estimate::{Batches, Beside, Sequences};
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
            Self::Trusted => Onward::Walks(WalkEnds::Trusted),
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
        Self { light, direct: None, eps, dark, beyond }
    }

    /// As made, but errors are to be small relative to the irradiance `dark` (W m⁻² per band) where less arrives.
    pub(super) fn with_dark(self, dark: Vec<f64>) -> Self {
        Self { dark, ..self }
    }

    /// As made, but the direct light of points is taken from `direct`.
    pub(super) fn beside(self, direct: DirectLight<'a>) -> Self {
        Self { direct: Some(direct), ..self }
    }

    /// Direct light (W m⁻² per band) of a point by cells; None where rays find it.
    pub(super) fn direct_by_cells(&self, receiver: &ReceiverPoint) -> Option<Vec<f64>> {
        let direct = self.direct.as_ref()?;
        Some(direct.irradiance(receiver, &direct.around(&receiver.site())))
    }

    /// All light of a receiver, by rays alone. It depends on nothing but the receiver.
    pub fn read(&self, origin: &Receiver) -> ReadIrradiance {
        let rays = ReceiverRays::all(&self.light, origin, self.beyond.onward(Held::READ));
        self.gathered(&rays, Sequences::Independent, FIRST, &vec![0.0; self.dark.len()])
    }

    /// The reflected light of a receiver alone, accurate relative to this and the light `other` (W m⁻² per band).
    pub(super) fn reflected_alone(&self, origin: &Receiver, other: &[f64]) -> ReadIrradiance {
        let rays = ReceiverRays::reflected(&self.light, origin, self.beyond.onward(Held::READ));
        self.gathered(&rays, Sequences::Independent, FIRST, other)
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
        self.gathered(&rays, Sequences::Independent, FIRST_OF_MANY, other)
    }

    /// The reflected light of a point alone, one of many, accurate relative to this and the light `other` (W m⁻²
    /// per band); from polynomials where these are trusted.
    pub fn reflected(&self, receiver: &ReceiverPoint, other: &[f64]) -> ReadIrradiance {
        let beyond = if self.beyond == Beyond::Trusted { Beyond::Polynomials } else { self.beyond };
        let origin = Receiver::Point(*receiver);
        let rays = ReceiverRays::reflected(&self.light, &origin, beyond.onward(Held::BEHIND_PIXELS));
        match beyond {
            Beyond::Polynomials => self.gathered(&rays, Sequences::OneAfterTheOther, FIRST_TOGETHER, other),
            _ => self.gathered(&rays, Sequences::Independent, FIRST_OF_MANY, other),
        }
    }

    /// Numbers of rays, of which `first` are sent before the error is looked at where they do not go on.
    fn counts(&self, first: u64) -> RayCounts {
        match self.beyond {
            Beyond::Walked => {
                RayCounts { first: FEWEST_WALKS, least: FIRST_WALKS, most: most_walks(self.eps) }
            }
            _ => RayCounts { first, least: first, most: most_rays(self.eps) },
        }
    }

    /// Light by these rays, of which `first` of each of the `sequences` are sent at first; `other` light (W m⁻² per
    /// band) arrives too.
    fn gathered(
        &self,
        rays: &ReceiverRays,
        sequences: Sequences,
        first: u64,
        other: &[f64],
    ) -> ReadIrradiance {
        let beside = Beside { scale: &self.light.scale, dark: &self.dark, other };
        let RayCounts { first, least, most } = self.counts(first);
        let number = rays.number();
        let mut batches = Batches::of(sequences, self.dark.len());
        let mut count = first;
        loop {
            batches.send(number, count, |number, indices, scores| rays.add(number, indices, scores));
            let estimate = batches.estimate(&beside);
            let is_enough = batches.sent() >= least && CAUTION * estimate.missed <= self.eps;
            if is_enough || batches.are_last(most) {
                return estimate.into();
            }
            count = batches.sent();
        }
    }
}
