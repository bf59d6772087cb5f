//! The choice of how light is gathered at points: by cells, or by rays.
//!
//! Cells ([`crate::gather::Gather`]) cost time in proportion to the elements and to what stands before them,
//! little more where more digits are asked for; least in small rooms of flat things. Rays
//! ([`crate::gather::ray_gather`]) cost about the same whatever the scene is, and ε^(−4/3).

use radiosity_elements::Element;
use radiosity_visibility::Visibility;
use serde::{Deserialize, Serialize};

use crate::gather::ray_gather::usual_rays;
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
}

impl GatherMethod {
    /// Whether rays gather light to the relative accuracy `eps`, `twice` or once.
    pub fn rays(self, solution: &Solution, visibility: &Visibility, eps: f64, twice: bool) -> bool {
        // Rays always meet what stands in their way, and know no masks.
        let is_plain = visibility.casts() && solution.masked().is_none();
        let is_cheaper = || {
            let peaks = if solution.emitters().points.is_empty() { 1.0 } else { PEAKS };
            let rays = if twice { 3.0 } else { 1.0 } * peaks * RAY * usual_rays(eps);
            rays < price_of_cells(solution, visibility)
        };
        match self {
            Self::Cells => false,
            Self::Rays => is_plain,
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
