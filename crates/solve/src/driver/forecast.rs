//! About the seconds that the pairs of a scene take, told before: nothing is chosen by them but how many rays
//! are sent where time is limited.
//!
//! With the prices of exact pairs ([`radiosity_transport::price`]), which are those of the dearest rooms,
//!
//! ```text
//! r · rays (a + b log₂ surfaces)     or     r (f · price of flat pairs + m · of mixed pairs + c · of curved pairs) .
//! ```

use radiosity_elements::{CutSize, Elements};
use radiosity_scene::Scene;
use radiosity_visibility::Visibility;
use radiosity_work::Allowance;

use super::choose_transport::{PairsPrice, price_of_pairs};
use super::cost::seconds_of_rays;

/// a and b. Measured on ten scenes of 7 to 5826 surfaces: right within a factor of two, the rays' error and exact pairs
/// beside them included, but for a shop with many curved pairs (8).
const OF_A_RAY: f64 = 0.4;
const DEEPER: f64 = 0.1;

/// f, m and c. Measured: flat pairs of eight rooms took a third to a tenth of their price, those of the Cornell
/// box with its curved surface a sixteenth, and curved ones of a teapot half to all of it.
const OF_FLAT: f64 = 1.0 / 6.0;
const OF_MIXED: f64 = 1.0 / 16.0;
const OF_CURVED: f64 = 0.7;

/// Part of the time left in which rays are sent by their forecast. Chosen: their error, the self-checks and a slow
/// machine have the rest.
const SENT: f64 = 0.7;

/// Seconds for each surface that are left for its elements, the systems and the files, and fewest rays for each.
/// Measured in a classroom of 5787 and 10 468 surfaces: 2.5e-4 to 3.2e-4. The latter is chosen.
const BESIDE: f64 = 2.5e-4;
const FEWEST: u64 = 16;

/// About the seconds that the blocks between the elements of a scene take two threads, by so many rays or exactly.
pub(super) fn seconds_of_pairs(
    scene: &Scene,
    elements: &Elements,
    visibility: &Visibility,
    rays: Option<u64>,
) -> f64 {
    let surfaces = scene.surfaces.len();
    if let Some(rays) = rays {
        return seconds_of_rays_among(rays, surfaces);
    }
    let size = |surface: usize| {
        let own = elements.of_surface(surface);
        let functions = elements.list().get(own.start).map_or(0, |first| first.basis.len() as u64);
        CutSize { elements: own.len() as u64, functions }
    };
    let sizes: Vec<CutSize> = (0..surfaces).map(size).collect();
    let sends = |surface: usize| scene.surfaces[surface].material.sends();
    seconds_of_exact(&price_of_pairs(scene, &sizes, &|i, j| sends(i) || sends(j), visibility))
}

/// About the seconds that so many rays take two threads among so many surfaces, with what is made of them.
pub(crate) fn seconds_of_rays_among(rays: u64, surfaces: usize) -> f64 {
    seconds_of_rays(rays as f64) * (OF_A_RAY + DEEPER * (surfaces.max(1) as f64).log2())
}

/// As many rays among so many surfaces as are sent in the time that is `left`, at most so many: elements are then
/// cut for no more.
pub(super) fn rays_in_time(most: u64, surfaces: usize, left: Option<Allowance>) -> u64 {
    let in_time = |left: Allowance| {
        let sent = SENT * (left.seconds() - BESIDE * surfaces as f64).max(0.0);
        let rays = left.forecast(sent) / seconds_of_rays_among(1, surfaces);
        most.min((rays as u64).max(FEWEST * surfaces as u64))
    };
    left.map_or(most, in_time)
}

/// About the seconds that exact pairs of this price take two threads.
pub(crate) fn seconds_of_exact(price: &PairsPrice) -> f64 {
    seconds_of_rays(OF_FLAT * price.flat + OF_MIXED * price.mixed + OF_CURVED * price.curved)
}
