//! About the seconds that the pairs of a scene take, told before: nothing is chosen by them.
//!
//! With the prices of exact pairs ([`radiosity_transport::price`]), which are those of the dearest rooms,
//!
//! ```text
//! r · rays (a + b log₂ surfaces)     or     r (f · price of flat pairs + c · price of curved pairs) .
//! ```

use super::choose_transport::{PairsPrice, price_of_pairs};
use super::cost::seconds_of_rays;
use super::ready::Ready;

/// a and b. Measured on ten scenes of 7 to 5826 surfaces: right within a factor of two, the rays' error and exact pairs
/// beside them included, but for a shop with many curved pairs (8).
const OF_A_RAY: f64 = 0.4;
const DEEPER: f64 = 0.1;

/// f and c. Measured on eight rooms: their flat pairs took a third to a sixteenth of their price; a teapot's curved ones
/// half.
const OF_FLAT: f64 = 1.0 / 6.0;
const OF_CURVED: f64 = 0.5;

/// About the seconds that the blocks between the elements of a scene take two threads.
pub(super) fn seconds_of_pairs(ready: &Ready) -> f64 {
    let Ready { scene, elements, visibility, rays, .. } = ready;
    let surfaces = scene.surfaces.len();
    if let Some(rays) = rays {
        return seconds_of_rays_among(*rays, surfaces);
    }
    let counts: Vec<u64> =
        (0..surfaces).map(|surface| elements.of_surface(surface).len() as u64).collect();
    let sends = |surface: usize| scene.surfaces[surface].material.sends();
    seconds_of_exact(&price_of_pairs(scene, &counts, &|i, j| sends(i) || sends(j), visibility))
}

/// About the seconds that so many rays take two threads among so many surfaces, with what is made of them.
pub(crate) fn seconds_of_rays_among(rays: u64, surfaces: usize) -> f64 {
    seconds_of_rays(rays as f64) * (OF_A_RAY + DEEPER * (surfaces.max(1) as f64).log2())
}

/// About the seconds that exact pairs of this price take two threads.
pub(crate) fn seconds_of_exact(price: &PairsPrice) -> f64 {
    seconds_of_rays(OF_FLAT * price.flat + OF_CURVED * price.curved)
}
