//! The choice of how light is gathered at points: by cells, or by rays.
//!
//! Cells ([`crate::gather::Gather`]) cost time in proportion to the elements and to what stands before them,
//! little more where more digits are asked for; least in small rooms of flat things. Rays
//! ([`crate::gather::ray_gather`]) cost about the same whatever the scene is, and ε^(−4/3).

use radiosity_elements::Element;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;
use serde::{Deserialize, Serialize};

use crate::gather::Gather;
use crate::gather::ray_count::usual_rays;
use crate::gather::ray_gather::{Beyond, RayGather};
use crate::gather::read_irradiance::ReadIrradiance;
use crate::gather::receiver::Receiver;
use crate::solution::Solution;

/// Seconds of a ray; of a flat element behind flat things, and for each of those; of one that is curved or
/// may lie behind something curved. Measured on one core: Cornell box, offices, teapot, soda shop.
const RAY: f64 = 0.7e-6;
const FLAT: f64 = 1.5e-6;
const BEHIND_FLAT: f64 = 0.02e-6;
const CURVED: f64 = 100e-6;

/// Rays among luminaires over those without: where one shines on a surface beside it, few rays meet the peak.
/// Chosen.
const PEAKS: f64 = 30.0;

/// Ways to gather light at points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum GatherMethod {
    /// By what is likely to be faster.
    #[default]
    Auto,
    /// By cells of all elements, divided until their rules are exact enough.
    Cells,
    /// By rays, until their error is small enough.
    Rays,
    /// By rays that go on from surface to surface until they end: no error of the solution is left.
    Walks,
}

/// Light that is gathered at points in one of the ways.
#[derive(Debug)]
pub enum Gathering<'a> {
    /// By cells.
    Cells(Gather<'a>),
    /// By rays.
    Rays(RayGather<'a>),
}

impl Gathering<'_> {
    /// All light of a point.
    pub fn read(&self, receiver: &ReceiverPoint) -> ReadIrradiance {
        match self {
            Self::Cells(gather) => gather.at(receiver).into(),
            Self::Rays(gather) => gather.read(&Receiver::Point(*receiver)),
        }
    }

    /// The reflected light of a point, one of many, beside the direct light `lit` (W m⁻² per band).
    pub fn reflected(&self, receiver: &ReceiverPoint, lit: &[f64]) -> ReadIrradiance {
        match self {
            Self::Cells(gather) => {
                let around = gather.reflection().around(&receiver.site());
                gather.reflection().irradiance(receiver, &around, lit).into()
            }
            Self::Rays(gather) => gather.reflected(receiver, lit),
        }
    }
}

impl GatherMethod {
    /// The light of `solution`, gathered `twice` or once by what this method chooses: by cells to about the
    /// relative accuracy `eps`, by rays to `rougher` times that.
    pub fn gathering<'a>(
        self,
        solution: &'a Solution,
        visibility: &'a Visibility,
        eps: f64,
        rougher: f64,
        twice: bool,
    ) -> Gathering<'a> {
        let by_rays = |beyond| Gathering::Rays(RayGather::new(solution, visibility, rougher * eps, beyond));
        match twice {
            _ if self == Self::Walks => by_rays(Beyond::Walked),
            _ if self.rays(solution, visibility, rougher * eps, twice) => {
                by_rays(if twice { Beyond::Gathered } else { Beyond::Polynomials })
            }
            true => Gathering::Cells(Gather::twice(solution, visibility, eps)),
            false => Gathering::Cells(Gather::new(solution, visibility, eps)),
        }
    }

    /// Whether rays gather light to the relative accuracy `eps`, `twice` or once.
    pub(crate) fn rays(self, solution: &Solution, visibility: &Visibility, eps: f64, twice: bool) -> bool {
        // Rays always meet what stands in their way, and know no masks.
        let is_plain = visibility.casts() && solution.masked().is_none();
        let is_cheaper = || {
            let peaks = if solution.emitters().points.is_empty() { 1.0 } else { PEAKS };
            let rays = if twice { 3.0 } else { 1.0 } * peaks * RAY * usual_rays(eps);
            rays < price_of_cells(solution, visibility)
        };
        match self {
            Self::Cells => false,
            Self::Rays | Self::Walks => is_plain,
            Self::Auto => is_plain && is_cheaper(),
        }
    }
}

/// About the seconds of one core that a point takes, once, to the relative accuracy `eps`.
pub fn seconds_to_gather(solution: &Solution, visibility: &Visibility, eps: f64) -> f64 {
    match GatherMethod::Auto.rays(solution, visibility, eps, false) {
        true => RAY * usual_rays(eps),
        false => price_of_cells(solution, visibility),
    }
}

/// Seconds for a point by cells.
fn price_of_cells(solution: &Solution, visibility: &Visibility) -> f64 {
    let surfaces = solution.elements().surfaces();
    let standing: Vec<usize> = (0..surfaces).filter(|surface| visibility.stands(*surface)).collect();
    let curved_blockers = standing.iter().filter(|surface| visibility.pieces(**surface).is_none()).count();
    // Something curved stands before about this share of all elements.
    let behind_curved = (curved_blockers as f64 / surfaces as f64).sqrt().min(1.0);
    let flat = FLAT + BEHIND_FLAT * standing.len() as f64;
    let price = |element: &Element| {
        if element.plane.is_none() { CURVED } else { flat + behind_curved * CURVED }
    };
    solution.elements().list().iter().filter(|element| element.contact.is_none()).map(price).sum()
}
